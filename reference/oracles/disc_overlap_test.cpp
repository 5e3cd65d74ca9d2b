// SPDX-License-Identifier: MIT
#include "reference/oracles/disc_overlap.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "reference/oracles/test_noise.hpp"

namespace phytobench::oracles {
namespace {

std::vector<OracleDisc> scene_of_ratio(unsigned count, double ratio) {
  std::vector<OracleDisc> discs;
  for (unsigned i = 0; i < count; ++i)
    discs.push_back(
        {10 * noise(3 * i), 8 * noise(3 * i + 1), 0.3 / std::pow(ratio, noise(3 * i + 2))});
  return discs;
}

void expect_equal(const std::vector<OracleOverlap>& a, const std::vector<OracleOverlap>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].i, b[k].i);
    EXPECT_EQ(a[k].j, b[k].j);
    EXPECT_EQ(a[k].distance, b[k].distance);
  }
}

TEST(DiscOverlapOracle, TableFindsWhatTheDoubleLoopFinds) {
  for (const OracleGround ground : {OracleGround{}, OracleGround{10, 8}})
    for (const double ratio : {1.0, 3.0, 1000.0}) {
      std::vector<OracleDisc> discs = scene_of_ratio(600, ratio);
      discs.push_back({5, 4, 3.9});  // reaches round the torus nearly to itself
      const auto literal = overlaps_literally(discs, ground);
      EXPECT_GT(literal.size(), 100u);
      expect_equal(overlaps_by_table(discs, ground), literal);
    }
}

TEST(DiscOverlapOracle, EachDiscHasItsSharesOfAll) {
  const std::vector<OracleDisc> discs = scene_of_ratio(200, 2.0);
  const OracleGround ground{10, 8};
  std::size_t sum = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) sum += overlaps_of(i, discs, ground).size();
  EXPECT_EQ(sum, 2 * overlaps_literally(discs, ground).size());
}

TEST(DiscOverlapOracle, TouchingIsNoOverlapAndOneBitIs) {
  EXPECT_TRUE(overlaps_literally({{0, 0, 1}, {3, 0, 2}}, {}).empty());
  EXPECT_EQ(overlaps_literally({{0, 0, 1}, {std::nextafter(3, 0), 0, 2}}, {}).size(), 1u);
  EXPECT_TRUE(overlaps_literally({{0, 0, 0}, {0, 0, 2}}, {}).empty());
  EXPECT_EQ(overlaps_literally({{1, 1, 1}, {9, 1, 1.5}}, {10, 8}).size(), 1u);
  EXPECT_EQ(overlaps_literally({{0, 0, 3.5}, {5, 4, 3.5}}, {10, 8}).size(), 4u);  // at four corners
}

}  // namespace
}  // namespace phytobench::oracles
