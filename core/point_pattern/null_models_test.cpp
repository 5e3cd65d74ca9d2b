// SPDX-License-Identifier: MIT
#include "core/point_pattern/null_models.hpp"

#include <array>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

TEST(RandomPattern, IsAFunctionOfSeedAndIndex) {
  const Points points = random_pattern(l_shape(), 200, 5, 6);
  EXPECT_EQ(points.size(), 200U);
  for (const Point2& p : points) EXPECT_TRUE(l_shape().contains(p));
  EXPECT_EQ(random_pattern(l_shape(), 200, 5, 6), points);
  EXPECT_NE(random_pattern(l_shape(), 200, 5, 7), points);
  EXPECT_NE(random_pattern(l_shape(), 200, 6, 6), points);
  EXPECT_TRUE(random_pattern(l_shape(), 0, 5, 6).empty());
}

TEST(Relabelled, KeepsTheMarksAndGivesEveryOrderItsChance) {
  const std::vector<double> marks{1.0, 2.0, 3.0};
  std::array<std::int64_t, 6> counts{};
  for (std::uint64_t index = 0; index < 6000; ++index) {
    std::vector<double> labels = relabelled(marks, 3, index);
    const auto a = static_cast<std::size_t>(labels[0]), b = static_cast<std::size_t>(labels[1]);
    ++counts[2 * (a - 1) + (b > 6 - a - b ? 1 : 0)];
    std::sort(labels.begin(), labels.end());
    EXPECT_EQ(labels, marks);
  }
  EXPECT_GT(uniformity_p_value(counts), 1e-4);
}

TEST(RelabelledSpecies, KeepsPlacesAndNumbers) {
  const Points first{{0.1, 0.1}, {0.2, 0.2}}, second{{0.3, 0.3}, {0.4, 0.4}, {0.5, 0.5}};
  std::array<std::int64_t, 5> counts{};
  for (std::uint64_t index = 0; index < 5000; ++index) {
    const TwoSpecies species = relabelled(first, second, 4, index);
    EXPECT_EQ(species.first.size(), 2U);
    double sum = 0.0;
    for (const Point2& p : species.first)
      ++counts[static_cast<std::size_t>(std::lround(10.0 * p.x)) - 1], sum += p.x;
    for (const Point2& p : species.second) sum += p.x;
    EXPECT_NEAR(sum, 1.5, 1e-12);
  }
  EXPECT_GT(uniformity_p_value(counts), 1e-4);
}

TEST(TorusShiftedLaw, KeepsDistancesOnATorus) {
  const Window window = Window::torus({{-1.0, 3.0}, {4.0, 6.0}});
  const Points points = random_points(window, 300, 1);
  const std::vector<double> distances{0.1, 0.5, 1.0, 1.4};
  for (std::uint64_t index = 0; index < 20; ++index) {
    const Points shifted = torus_shifted(points, window, 2, index);
    EXPECT_EQ(close_pair_counts(shifted, window, distances),
              close_pair_counts(points, window, distances));
  }
}

TEST(TorusShiftedLaw, SpreadsAPointEvenly) {
  std::array<std::int64_t, 16> counts{};
  const Window window = Window::rectangle(unit_square);
  for (std::uint64_t index = 0; index < 4000; ++index) {
    const Point2 p = torus_shifted(Points{{1.0, 0.25}}, window, 9, index)[0];
    ++counts[static_cast<std::size_t>(4.0 * p.x) * 4 + static_cast<std::size_t>(4.0 * p.y)];
  }
  EXPECT_GT(uniformity_p_value(counts), 1e-4);
}

TEST(TorusShifted, StaysInsideAndRefusesPolygons) {
  const Window window = Window::rectangle({{1e6, 0.1}, {1e6 + 0.3, 0.7}});
  for (std::uint64_t index = 0; index < 500; ++index)
    for (const Point2& p : torus_shifted(window.corners(), window, 3, index))
      EXPECT_TRUE(window.contains(p));
  EXPECT_THROW(torus_shifted({}, l_shape(), 1, 0), ContractViolation);
  EXPECT_THROW(torus_shifted(Points{{0.0, 0.0}}, window, 1, 0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
