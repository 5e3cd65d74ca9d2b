// SPDX-License-Identifier: MIT
#include "core/contract/counted_noun.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(CountedNoun, OneAloneIsSingular) {
  EXPECT_EQ(counted_noun(0, "segment"), "0 segments");
  EXPECT_EQ(counted_noun(1, "segment"), "1 segment");
  EXPECT_EQ(counted_noun(2, "segment"), "2 segments");
  EXPECT_EQ(counted_noun(18446744073709551615u, "segment"), "18446744073709551615 segments");
}

TEST(CountedNoun, TakesAPluralOfItsOwn) {
  EXPECT_EQ(counted_noun(0, "vertex", "vertices"), "0 vertices");
  EXPECT_EQ(counted_noun(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted_noun(9, "vertex", "vertices"), "9 vertices");
}

}  // namespace
}  // namespace phytobench
