// SPDX-License-Identifier: MIT
#include "core/overlap/discs.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(OverlapPairs, SortsAndAddsUpImages) {
  OverlapPairs pairs;
  pairs.push_back(2, 3, 1.0);
  pairs.push_back(0, 3, 0.25);
  pairs.push_back(0, 1, 0.5);
  pairs.push_back(0, 3, 0.125);
  pairs.sort_and_merge(4);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_THAT(pairs.first(), testing::ElementsAre(0, 0, 2));
  EXPECT_THAT(pairs.second(), testing::ElementsAre(1, 3, 3));
  EXPECT_THAT(pairs.area(), testing::ElementsAre(0.5, 0.375, 1.0));
}

TEST(ProblemWith, NamesTheFirstDiscThatNoEngineCanTake) {
  const auto problem = [](double x, double r, bool is_torus = false) {
    const std::vector<double> xs{1, x}, ys{1, 2}, radii{1, r};
    Ground ground;
    if (is_torus) ground.torus = Rectangle{{0, 0}, {10, 20}};
    const auto found = problem_with({xs, ys, radii}, ground);
    return found ? std::to_string(found->disc) + ": " + found->what : "";
  };
  EXPECT_EQ(problem(5, 1), "");
  EXPECT_EQ(problem(5, 0), "");
  EXPECT_EQ(problem(5, 4.99, true), "");
  EXPECT_THAT(problem(5, -1), testing::HasSubstr("1: radius -1 is negative"));
  EXPECT_THAT(problem(5, 1e-80), testing::HasSubstr("1e-60"));
  EXPECT_THAT(problem(1e61, 1), testing::HasSubstr("beyond"));
  EXPECT_THAT(problem(11, 1, true), testing::HasSubstr("outside"));
  EXPECT_THAT(problem(5, 5, true), testing::HasSubstr("round the torus"));
  EXPECT_THAT(problem(std::nan(""), 1), testing::HasSubstr("1: "));
}

}  // namespace
}  // namespace phytobench
