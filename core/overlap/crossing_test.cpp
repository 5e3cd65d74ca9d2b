// SPDX-License-Identifier: MIT
#include "core/overlap/crossing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// Circles of all ratios of radii, hardly or nearly crossing, or with almost one center.
TEST(CrossingLaw, PointsLieOnBothCircles) {
  CounterStream stream(1, 0);
  for (int k = 0; k < 20'000; ++k) {
    const double s = 1.0, r = std::pow(10.0, -6.0 * stream.next_unit() * (k % 2));
    const double least = s - r, most = s + r;
    const double near = std::pow(10.0, -14.0 * stream.next_unit());
    const double distance = k % 3 == 0   ? least + near * r
                            : k % 3 == 1 ? most - near * r
                                         : least + stream.next_unit() * r;
    const double angle = 6.28 * stream.next_unit();
    const Point2 between{distance * std::cos(angle), distance * std::sin(angle)};
    const double apart = norm(between);
    if (apart <= least || apart >= most) continue;
    const Crossing c = crossing_of(r, s, between, apart);
    for (const Point2& p : {c.enter, c.exit}) {
      EXPECT_NEAR(norm(p) / r, 1.0, 1e-14);
      EXPECT_NEAR(norm(p - between), s, 1e-14);
    }
    EXPECT_GE(cross(between, c.exit) - cross(between, c.enter), 0.0);
  }
}

TEST(Crossing, IsSymmetricInTheCircles) {
  const Point2 between{0.3, 0.4};
  const Crossing one = crossing_of(0.7, 0.8, between, 0.5);
  const Crossing other = crossing_of(0.8, 0.7, Point2{} - between, 0.5);
  EXPECT_NEAR(norm(one.enter - (between + other.exit)), 0.0, 1e-15);
  EXPECT_NEAR(norm(one.exit - (between + other.enter)), 0.0, 1e-15);
}

TEST(SegmentArea, IsOneFunctionAcrossItsSeries) {
  for (const double angle : {1e-8, 1e-3, 0.4999999, 0.5, 0.5000001, 3.0, 6.2}) {
    const long double a = angle;
    const double exact =
        static_cast<double>(angle < 1e-2 ? a * a * a / 12 * (1 - a * a / 20 * (1 - a * a / 42))
                                         : (a - std::sin(a)) / 2);
    EXPECT_NEAR(segment_area(1.0, angle) / exact, 1.0, 1e-14) << angle;
  }
}

}  // namespace
}  // namespace phytobench
