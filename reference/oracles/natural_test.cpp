// SPDX-License-Identifier: MIT
#include "reference/oracles/natural.hpp"

#include <gtest/gtest.h>

namespace phytobench::oracles {
namespace {

TEST(NaturalLaw, AddsLikeMachineWords) {
  std::uint64_t a = 1, b = 7;
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ((Natural(a) + Natural(b)).in_64_bits(), a + b);
    EXPECT_EQ(Natural(a) + Natural(b), Natural(b) + Natural(a));
    EXPECT_EQ(Natural(a).text(), std::to_string(a));
    a = a * 3 % 1'000'000'007;
    b = b * 10 % 999'999'937;
  }
  EXPECT_EQ(Natural(0) + Natural(0), Natural(0));
  EXPECT_EQ(Natural(0).text(), "0");
  EXPECT_EQ(Natural(999) + Natural(1), Natural(1000));
}

TEST(Natural, SaysWhere64BitsEnd) {
  const std::uint64_t greatest = ~std::uint64_t{0};
  EXPECT_EQ(Natural(greatest).in_64_bits(), greatest);
  const Natural more = Natural(greatest) + Natural(1);
  EXPECT_EQ(more.text(), "18446744073709551616");
  EXPECT_EQ(more.in_64_bits(), std::nullopt);
  EXPECT_EQ(more.in_double(), 18446744073709551616.0);
  EXPECT_EQ((more + more).in_64_bits(), std::nullopt);
}

TEST(Natural, HoldsTheHundredthPowerOfTwo) {
  Natural power(1);
  for (int i = 0; i < 100; ++i) power += Natural(power);
  EXPECT_EQ(power.text(), "1267650600228229401496703205376");
}

}  // namespace
}  // namespace phytobench::oracles
