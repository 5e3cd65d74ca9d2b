// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/empty_space.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr Rectangle plot{{-1.0, 0.0}, {2.0, 2.0}};

/// Mean distance from the middle of the unit square: (sqrt 2 + asinh 1) / 6.
TEST(EmptySpaceByAllBisectors, HasTheClosedFormsOfSquares) {
  const Rectangle box{{0.0, 0.0}, {12.0, 12.0}};
  for (const auto& points : {std::vector<Point2>{{6.0, 6.0}}, square_lattice(box, 12, 12)}) {
    const double side = std::sqrt(144.0 / static_cast<double>(points.size()));
    const EmptySpaceMoments found = empty_space_by_all_bisectors(points, box);
    EXPECT_NEAR(found.mean_distance, 0.38259785823210635 * side, 1e-13 * side);
    EXPECT_NEAR(found.mean_squared_distance, side * side / 6.0, 1e-13 * side * side);
  }
}

/// Cells of points on the border and in corners lack triangles.
TEST(EmptySpaceByAllBisectors, KnowsPointsOnTheBorderAndTwins) {
  const Rectangle unit{{0.0, 0.0}, {1.0, 1.0}};
  const std::vector<Point2> corner{{0.0, 0.0}, {0.0, 0.0}};
  // The whole square from its corner is a quarter of one twice as wide from its middle.
  EXPECT_NEAR(empty_space_by_all_bisectors(corner, unit).mean_distance, 2.0 * 0.38259785823210635,
              1e-14);
  const std::vector<Point2> corners{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}};
  EXPECT_NEAR(empty_space_by_all_bisectors(corners, unit).mean_distance, 0.38259785823210635,
              1e-14);
}

TEST(EmptySpaceByAllBisectorsOracle, IsTheMeanOverSmallSquares) {
  CounterStream stream(2, 0);
  const auto points = uniform_points(Window::rectangle(plot), 25, stream);
  constexpr int steps = 600;
  double sum = 0.0, squares = 0.0;
  for (int row = 0; row < steps; ++row)
    for (int column = 0; column < steps; ++column) {
      const Point2 place{plot.low.x + plot.width() * (column + 0.5) / steps,
                         plot.low.y + plot.height() * (row + 0.5) / steps};
      double least = INFINITY;
      for (const Point2& point : points) least = std::min(least, squared_norm(point - place));
      sum += std::sqrt(least);
      squares += least;
    }
  const EmptySpaceMoments found = empty_space_by_all_bisectors(points, plot);
  // Squares a hundredth as wide as a cell: the sum is off by some 1e-5.
  EXPECT_NEAR(found.mean_distance / (sum / steps / steps), 1.0, 1e-4);
  EXPECT_NEAR(found.mean_squared_distance / (squares / steps / steps), 1.0, 1e-4);
}

}  // namespace
}  // namespace phytobench
