// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/pattern_checks.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/point_pattern/dart_throwing.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/ripley.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using Points = std::vector<Point2>;

constexpr Rectangle checked_plot{{-1.0, 0.0}, {1.0, 1.0}};
const Window window = Window::rectangle(checked_plot);

Points some_points() {
  CounterStream stream(2, 0);
  return uniform_points(window, 300, stream);
}

TEST(HopkinsCheck, SeesTheTenthDigit) {
  const Points points = some_points();
  const HopkinsIndex right = hopkins_exact(points, window);
  EXPECT_EQ(objection_to_hopkins(right, points, checked_plot), "");
  for (const double factor : {1.0 + 1e-10, 1.0 - 1e-10}) {
    EXPECT_NE(objection_to_hopkins({factor * right.mean_ratio, right.squared_ratio}, points,
                                   checked_plot),
              "");
    EXPECT_NE(objection_to_hopkins({right.mean_ratio, factor * right.squared_ratio}, points,
                                   checked_plot),
              "");
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(objection_to_hopkins({nan, right.squared_ratio}, points, checked_plot), "");
  EXPECT_NE(objection_to_hopkins({right.mean_ratio, nan}, points, checked_plot), "");
  EXPECT_NE(objection_to_hopkins({}, points, checked_plot), "");
}

TEST(HopkinsCheck, SeesWhatIsSampledAndWhatIsOfOtherPoints) {
  Points points = some_points();
  CounterStream stream(3, 0);
  EXPECT_NE(
      objection_to_hopkins(hopkins_sampled(points, window, 100'000, stream), points, checked_plot),
      "");
  const HopkinsIndex right = hopkins_exact(points, window);
  points[7].x += 1e-6;
  EXPECT_NE(objection_to_hopkins(right, points, checked_plot), "");
}

TEST(RipleyCheck, SeesOneWrongValue) {
  const Points points = some_points();
  const std::vector<double> distances{0.05, 0.1, 0.2};
  const auto right = ripley_k(points, window, distances, EdgeCorrection::translation);
  EXPECT_EQ(objection_to_ripley_k(right, points, checked_plot, distances), "");
  auto wrong = right;
  wrong[1] *= 1.0 + 1e-10;
  EXPECT_THAT(objection_to_ripley_k(wrong, points, checked_plot, distances), HasSubstr("K(0.1)"));
  wrong.pop_back();
  EXPECT_THAT(objection_to_ripley_k(wrong, points, checked_plot, distances), HasSubstr("2 values"));
  const auto uncorrected = ripley_k(points, window, distances, EdgeCorrection::none);
  EXPECT_NE(objection_to_ripley_k(uncorrected, points, checked_plot, distances), "");
}

TEST(NearestDistancesCheck, SeesTheLastBit) {
  const Points points = some_points();
  std::vector<double> distances = nearest_distances(points, window);
  EXPECT_EQ(objection_to_nearest_distances(distances, points), "");
  distances[7] = std::nextafter(distances[7], 1.0);
  EXPECT_THAT(objection_to_nearest_distances(distances, points), HasSubstr("point 7"));
  distances[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(objection_to_nearest_distances(distances, points), HasSubstr("point 7"));
}

TEST(DartsCheck, SeesDartsThatAreTooNearOutsideOrMissing) {
  constexpr double distance = 0.1;
  CounterStream stream(4, 0);
  const Points right = dart_points(window, distance, until_saturated, stream);
  const auto objection = [&](const Points& darts) {
    return objection_to_darts(darts, window, distance, 1);
  };
  EXPECT_EQ(objection(right), "");
  Points wrong = right;
  wrong.push_back(right[0] + Point2{0.099, 0.0});
  EXPECT_THAT(objection(wrong), HasSubstr("from another"));
  wrong.back() = {1.5, 0.5};
  EXPECT_THAT(objection(wrong), HasSubstr("outside"));
  wrong.assign(right.begin() + 10, right.end());
  EXPECT_THAT(objection(wrong), HasSubstr("room for one more"));
  EXPECT_THAT(objection({}), HasSubstr("room for one more"));
}

}  // namespace
}  // namespace phytobench
