// SPDX-License-Identifier: MIT
#include "benchmarks/point_pattern/hopkins_race.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/null_models.hpp"

namespace phytobench {
namespace {

const Rectangle plot{{0, 0}, {3, 2}};

TEST(HopkinsRace, TimesWaysThatAgree) {
  const auto ways = race_hopkins({.points = random_pattern(Window::rectangle(plot), 3000, 1, 0),
                                  .window = plot,
                                  .threads = 2,
                                  .rounds = 3});
  ASSERT_EQ(ways.size(), 4u);
  for (const HopkinsWay& way : ways) {
    if (!way.missing.empty()) continue;
    EXPECT_EQ(way.objection, "") << way.name;
    EXPECT_EQ(way.seconds.size(), 3u) << way.name;
    EXPECT_NEAR(way.index.mean_ratio, 1.0, 0.1) << way.name;
  }
}

TEST(HopkinsRace, ObjectsToWhatDiffers) {
  const HopkinsIndex right{1.02, 1.05};
  EXPECT_EQ(objection_to(right, right, 0.0), "");
  EXPECT_EQ(objection_to({1.0201, 1.05}, right, 1e-3), "");
  EXPECT_NE(objection_to({1.0301, 1.05}, right, 1e-3), "");
  EXPECT_NE(objection_to({1.02, 1.06}, right, 1e-3), "");
  EXPECT_NE(objection_to({std::nan(""), 1.05}, right, 1e-3), "");
  // Twins: a k-d tree gives the point itself or its twin, and both ways agree on 0; but of points
  // all at one place there is no index to compare.
  const auto ways =
      race_hopkins({.points = std::vector<Point2>(50, Point2{1, 1}), .window = plot, .rounds = 1});
  EXPECT_NE(ways.back().objection, "");
  EXPECT_TRUE(ways.back().seconds.empty());
}

TEST(HopkinsRace, StopsWhenAskedTo) {
  EXPECT_THROW(
      race_hopkins(
          {.points = {{1, 1}, {2, 1}}, .window = plot, .is_interrupted = [] { return true; }}),
      Interrupted);
}

}  // namespace
}  // namespace phytobench
