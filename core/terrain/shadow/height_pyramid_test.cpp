// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/height_pyramid.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/shadow/test_terrains.hpp"

namespace phytobench {
namespace {

using namespace testing_terrains;

double highest_in(const HeightField& field, int left, int top, int columns, int rows) {
  double highest = -std::numeric_limits<double>::infinity();
  for (int row = std::max(top, 0); row < std::min(top + rows, field.rows()); ++row)
    for (int column = std::max(left, 0); column < std::min(left + columns, field.columns());
         ++column)
      if (field.at(column, row) > highest) highest = field.at(column, row);
  return highest;
}

double window(const HeightPyramid::Level& level, int column, int row) {
  return static_cast<double>(
      level.highest[static_cast<std::size_t>(row) * static_cast<std::size_t>(level.columns) +
                    static_cast<std::size_t>(column)]);
}

/// Not below it, and above by a unit of single precision at most.
void expect_bounds(double found, double highest) {
  EXPECT_GE(found, highest);
  if (std::isfinite(highest) && std::abs(highest) < 1e38)
    EXPECT_LE(found - highest, 1.2e-7 * std::abs(highest));
}

TEST(HeightPyramid, WindowsHoldTheGreatestHeightOfTheirVertices) {
  for (const Terrain& terrain : terrains()) {
    const HeightPyramid pyramid(terrain.field);
    EXPECT_EQ(pyramid.highest(), height_range(terrain.field).highest) << terrain.name;
    std::size_t bytes = 0;
    for (const HeightPyramid::Level& level : pyramid.levels()) {
      const int side = level.vertices_a_side();
      bytes += level.highest.size() * sizeof(float);
      for (int row = 0; row < level.rows; ++row)
        for (int column = 0; column < level.columns; ++column)
          expect_bounds(window(level, column, row), highest_in(terrain.field, column << level.shift,
                                                               row << level.shift, side, side));
    }
    EXPECT_GE(pyramid.bytes(), bytes);
  }
}

/// A box that begins in a window's first quarter lies within it; beyond the border there is none.
TEST(HeightPyramid, EveryBoxLiesInTheWindowInWhichItBegins) {
  const HeightField field = with_holes(fractal(101, 58, 300.0, 1), 0.05, 1);
  const HeightPyramid pyramid(field);
  CounterStream stream(1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const auto below = [&](int end) { return static_cast<int>(stream.next_unit() * end); };
    const int left = below(101), top = below(58), columns = 1 + below(150), rows = 1 + below(90);
    const HeightPyramid::Level& level = pyramid.level_for(columns, rows);
    EXPECT_GE(window(level, left >> level.shift, top >> level.shift),
              highest_in(field, left, top, columns, rows))
        << left << ", " << top << ": " << columns << " x " << rows;
    if (&level != &pyramid.levels().front())
      EXPECT_GT(std::max(columns, rows), (&level - 1)->side()) << "a smaller window would do";
  }
}

TEST(HeightPyramid, TakesMapsOfASingleRowColumnOrVertex) {
  HeightField one(1, 1, 1.0, 1.0, -3.0);
  const HeightPyramid vertex(one);
  ASSERT_EQ(vertex.levels().size(), 1u);
  EXPECT_EQ(window(vertex.levels()[0], 0, 0), -3.0);
  one.at(0, 0) = HeightField::no_data;
  EXPECT_EQ(window(HeightPyramid(one).levels()[0], 0, 0), -std::numeric_limits<double>::infinity());
  HeightField column(1, 70, 1.0, 1.0);
  column.at(0, 69) = 5.0;
  const HeightPyramid tall(column);
  EXPECT_EQ(window(tall.levels().back(), 0, 0), 5.0);
  EXPECT_EQ(window(tall.levels().front(), 0, 0), 0.0);
}

TEST(HeightPyramid, RoundsHeightsOfDoublePrecisionUp) {
  for (const double height : {0.1, -0.1, 1e300, -1e300, 16777217.0}) {
    const HeightField field(2, 2, 1.0, 1.0, height);
    EXPECT_GE(window(HeightPyramid(field).levels()[0], 0, 0), height);
  }
}

}  // namespace
}  // namespace phytobench
