// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_tiles.hpp"

#include <cstddef>

#include <gtest/gtest.h>

namespace phytobench::oracles::alsweis::tiles {
namespace {

TEST(LiteralTiles, AreTwoForEveryPairOfColours) {
  const auto sets = sets_of_tiles(2);
  EXPECT_EQ(sets.size(), 1296u);  // 6 to the fourth
  for (const auto& set : sets) {
    ASSERT_EQ(set.size(), 8u);
    int of_pair[4] = {};
    for (const Tile& tile : set) ++of_pair[2 * tile.north + tile.west];
    for (const int tiles : of_pair) EXPECT_EQ(tiles, 2);
  }
}

TEST(LiteralTiles, PeriodsAreFound) {
  EXPECT_EQ(tiles_of_smallest_period({{0, 1, 0, 1}}), 1);
  EXPECT_EQ(tiles_of_smallest_period({{0, 1, 0, 0}, {0, 0, 0, 1}}), 2);  // a row of two
  EXPECT_EQ(tiles_of_smallest_period({{0, 1, 1, 1}, {1, 1, 0, 1}}), 2);  // a column of two
  EXPECT_EQ(tiles_of_smallest_period({{0, 1, 1, 1}}), 0);
}

TEST(LiteralTiles, NoSetIsAperiodic) {
  EXPECT_EQ(tiles_of_largest_smallest_period(2), 2);
  EXPECT_EQ(tiles_of_largest_smallest_period(4), 1);  // with all 16 tiles
  EXPECT_EQ(tiles_of_largest_smallest_period(1), 0);  // four tiles may need more than two
}

TEST(LiteralSupersampling, KeepsAConstantOnlyWhenCorrected) {
  const auto constant = [](int, int) { return 3.0; };
  EXPECT_EQ(equation_6_2_as_printed(1), 9.0);
  EXPECT_EQ(equation_6_2_corrected(1), 16.0);
  for (const int k : {0, 1, 2, 3}) {
    EXPECT_DOUBLE_EQ(equation_6_1(constant, 4, -7, k, equation_6_2_corrected(k)), 3.0);
    EXPECT_EQ(equation_6_2_as_printed(k) < equation_6_2_corrected(k), k > 0);
  }
}

TEST(LiteralSupersampling, OfALineIsItsMiddle) {
  const auto line = [](int p, int q) { return 2.0 * p - q; };
  EXPECT_DOUBLE_EQ(equation_6_1(line, 5, 2, 2, equation_6_2_corrected(2)), 8.0);
}

TEST(LiteralRefinement, LeavesOnlyEqualPlantsInConflict) {
  EXPECT_EQ(conflicts_left(1.0, 1.0, 1.0, 0.05, deleted_as_printed), 1);
  EXPECT_EQ(conflicts_left(1.0, 1.0, 1.0, 0.05, deleted_corrected), 0);
  EXPECT_EQ(conflicts_left(1.0, 1.0, 2.0, 0.05, deleted_as_printed), 0);  // they only touch
  EXPECT_EQ(conflicts_left(1.0, 1.1, 1.0, 0.05, deleted_as_printed), 0);
}

TEST(LiteralRefinement, DeletesTheSmallerPlant) {
  for (const auto rule : {deleted_as_printed, deleted_corrected}) {
    EXPECT_EQ(rule(1.0, 2.0), 1);
    EXPECT_EQ(rule(2.0, 1.0), 2);
  }
  EXPECT_EQ(radius_left_of_figure_6_5_by_rule(2.0, 1.0), 2.0);
  EXPECT_EQ(radius_left_of_figure_6_5_as_told(2.0, 1.0), 1.0);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::tiles
