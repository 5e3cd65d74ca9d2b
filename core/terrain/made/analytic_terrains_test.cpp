// SPDX-License-Identifier: MIT
#include "core/terrain/made/analytic_terrains.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

// Heights here are a few roundings from their closed forms.
constexpr double rounding_m = 1e-11;
constexpr double root_3 = std::numbers::sqrt3;

// Cells that are not square, an odd and an even number of them.
constexpr MapGrid odd{.columns = 41, .rows = 31, .cell_width = 16.0, .cell_depth = 24.0};
constexpr MapGrid even{.columns = 40, .rows = 30, .cell_width = 16.0, .cell_depth = 24.0};

TEST(FlatTerrain, IsFlat) {
  const HeightField field = flat_terrain(odd, 12.5);
  EXPECT_EQ(field.columns(), 41);
  EXPECT_EQ(field.rows(), 31);
  EXPECT_EQ(field.cell_width(), 16.0);
  EXPECT_EQ(field.cell_depth(), 24.0);
  const HeightRange range = height_range(field);
  EXPECT_EQ(range.lowest, 12.5);
  EXPECT_EQ(range.highest, 12.5);
}

TEST(PlaneTerrain, FallsTowardsItsAspectWithItsSlope) {
  const HeightField east = plane_terrain(odd, 45.0, 0.0);
  EXPECT_EQ(east.at(20, 15), 0.0);
  EXPECT_EQ(east.at(25, 3), -5 * 16.0) << "45 degrees rise by exactly the distance";
  const HeightField south = plane_terrain(odd, 45.0, 90.0);
  EXPECT_EQ(south.at(7, 20), -5 * 24.0);
  EXPECT_EQ(plane_terrain(odd, 45.0, 270.0).at(7, 20), 5 * 24.0);
  const HeightField between = plane_terrain(odd, 60.0, 45.0);
  const double along = (5 * 16.0 + 5 * 24.0) / std::numbers::sqrt2;
  EXPECT_NEAR(between.at(25, 20), -root_3 * along, rounding_m);
}

TEST(RidgeTerrain, HasItsCrestInTheMiddleAndIsTheSameOnBothSides) {
  const HeightField field = ridge_terrain(odd, 30.0);
  EXPECT_EQ(field.at(0, 0), 0.0);
  EXPECT_NEAR(field.at(5, 15), 15 * 24.0 / root_3, rounding_m);
  EXPECT_NEAR(field.at(5, 10), 10 * 24.0 / root_3, rounding_m);
  for (int row = 0; row < 31; ++row)
    for (int column = 0; column < 41; ++column)
      EXPECT_EQ(field.at(column, row), field.at(0, 30 - row)) << column << ", " << row;
  const HeightField without_middle = ridge_terrain(even, 45.0);
  EXPECT_EQ(without_middle.at(3, 14), without_middle.at(3, 15));
  EXPECT_EQ(without_middle.at(3, 14), 14 * 24.0);
}

TEST(VValleyTerrain, IsTheRidgeUpsideDown) {
  const HeightField valley = v_valley_terrain(odd, 30.0), ridge = ridge_terrain(odd, 30.0);
  EXPECT_EQ(valley.at(9, 15), 0.0);
  for (int row = 0; row < 31; ++row)
    EXPECT_NEAR(valley.at(9, row) + ridge.at(9, row), ridge.at(9, 15), rounding_m);
}

TEST(CreaseTerrain, IsFlatInTheWestAndRisesInTheEast) {
  const HeightField field = crease_terrain(odd, 45.0);
  EXPECT_EQ(field.at(0, 3), 0.0);
  EXPECT_EQ(field.at(20, 3), 0.0);
  EXPECT_EQ(field.at(21, 3), 16.0);
  EXPECT_EQ(field.at(40, 30), 320.0);
}

TEST(ConeTerrain, IsRoundOnCellsThatAreNotSquare) {
  const HeightField field = cone_terrain(odd, 60.0, 200.0);
  EXPECT_NEAR(field.at(20, 15), root_3 * 200.0, rounding_m);
  // 3 x 16 = 2 x 24 m from the centre.
  EXPECT_EQ(field.at(23, 15), field.at(20, 17));
  EXPECT_EQ(field.at(17, 15), field.at(20, 13));
  EXPECT_NEAR(field.at(23, 15), root_3 * (200.0 - 48.0), rounding_m);
  EXPECT_EQ(field.at(33, 15), 0.0) << "208 m from the centre";
  EXPECT_GT(field.at(32, 15), 0.0) << "192 m from the centre";
}

TEST(HemisphereTerrain, EveryPointOfItIsAsFarFromTheCentre) {
  const HeightField field = hemisphere_terrain(odd, 250.0);
  EXPECT_EQ(field.at(20, 15), 250.0);
  int on_it = 0;
  for (int row = 0; row < 31; ++row)
    for (int column = 0; column < 41; ++column) {
      const double x = (column - 20) * 16.0, y = (row - 15) * 24.0, z = field.at(column, row);
      if (z == 0.0) {
        EXPECT_GE(std::hypot(x, y), 250.0);
        continue;
      }
      EXPECT_NEAR(std::hypot(x, y, z), 250.0, 1e-9);
      ++on_it;
    }
  // Area pi r^2 in cells of 16 x 24 m: 511; the border is 100 cells long.
  EXPECT_NEAR(on_it, std::numbers::pi * 250.0 * 250.0 / (16.0 * 24.0), 25.0);
}

TEST(RingWallTerrain, StandsFromItsRadiusOn) {
  const HeightField field = ring_wall_terrain(odd, 160.0, 32.0, 90.0);
  EXPECT_EQ(field.at(20, 15), 0.0);
  EXPECT_EQ(field.at(29, 15), 0.0) << "144 m";
  EXPECT_EQ(field.at(30, 15), 90.0) << "160 m";
  EXPECT_EQ(field.at(31, 15), 90.0);
  EXPECT_EQ(field.at(32, 15), 0.0) << "192 m";
  EXPECT_EQ(field.at(20, 22), 90.0) << "168 m to the south";
}

TEST(NeedleTerrain, IsOneVertex) {
  for (const MapGrid& grid : {odd, even, MapGrid{}}) {
    const HeightField field = needle_terrain(grid, 1000.0);
    double sum = 0.0;
    for (const double height : field.heights()) sum += height;
    EXPECT_EQ(sum, 1000.0);
    EXPECT_EQ(field.at(grid.columns / 2, grid.rows / 2), 1000.0);
  }
}

TEST(AnalyticTerrains, SlopesThatAreNoneBreakTheContract) {
  EXPECT_THROW(plane_terrain(odd, 90.0, 0.0), ContractViolation);
  EXPECT_THROW(ridge_terrain(odd, -1.0), ContractViolation);
  EXPECT_THROW(flat_terrain({.columns = 0}, 1.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
