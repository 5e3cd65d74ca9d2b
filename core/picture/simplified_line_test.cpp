// SPDX-License-Identifier: MIT
#include "core/picture/simplified_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

using Line = std::vector<Point2>;

/// By the height of the triangle over a piece, or by its ends.
double distance_to(const Line& line, const Point2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 from = p - line[i], to = p - line[i + 1], along = line[i + 1] - line[i];
    least = std::min({least, norm(from), norm(to)});
    if (dot(from, along) > 0.0 && dot(to, along) < 0.0)
      least = std::min(least, std::abs(cross(from, along)) / norm(along));
  }
  return least;
}

TEST(SimplifiedLine, KeepsOnlyTheEndsOfAStraightLine) {
  EXPECT_EQ(simplified_line({{0, 0}, {1, 1}, {2, 2}, {5, 5}}, 0.0), (Line{{0, 0}, {5, 5}}));
}

TEST(SimplifiedLine, KeepsCornersAndTurns) {
  const Line corner{{0, 0}, {2, 0}, {2, 3}}, back{{0, 0}, {4, 0}, {1, 0}},
      loop{{0, 0}, {1, 0}, {1, 1}, {0, 0}};
  for (const Line& line : {corner, back, loop}) EXPECT_EQ(simplified_line(line, 0.1), line);
}

TEST(SimplifiedLine, StaysWithinItsToleranceOfEveryPoint) {
  Line wave;
  for (int i = 0; i <= 500; ++i) wave.push_back({0.6 * i, 40.0 * std::sin(0.03 * i)});
  for (const double tolerance : {0.1, 0.5, 5.0}) {
    const Line simple = simplified_line(wave, tolerance);
    EXPECT_LT(simple.size(), wave.size() / 4);
    for (const Point2& p : wave) EXPECT_LE(distance_to(simple, p), tolerance * (1.0 + 1e-12));
  }
  EXPECT_LT(simplified_line(wave, 5.0).size(), simplified_line(wave, 0.1).size());
}

TEST(SimplifiedLine, LeavesShortLinesAlone) {
  EXPECT_TRUE(simplified_line({}, 1.0).empty());
  EXPECT_EQ(simplified_line({{1, 2}}, 1.0), (Line{{1, 2}}));
  EXPECT_EQ(simplified_line({{1, 2}, {1, 2}}, 1.0), (Line{{1, 2}, {1, 2}}));
}

}  // namespace
}  // namespace phytobench
