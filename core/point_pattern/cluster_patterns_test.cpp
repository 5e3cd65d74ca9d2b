// SPDX-License-Identifier: MIT
#include "core/point_pattern/cluster_patterns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

using test_patterns::l_shape;
using test_patterns::least_p;
using test_patterns::standard_errors;
using test_patterns::unit_plot;
using test_patterns::unit_torus;

constexpr ClusterNumbers fixed_numbers(double parents, double offspring) {
  return {.parents = parents,
          .parents_law = NumberLaw::fixed,
          .offspring = offspring,
          .offspring_law = NumberLaw::fixed};
}

std::vector<Point2> thomas(const Window& window, const ThomasOptions& options, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  return thomas_points(window, options, stream);
}

std::vector<Point2> matern(const Window& window, const MaternOptions& options, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  return matern_cluster_points(window, options, stream);
}

/// Ways from the only parent, which the first two numbers of the stream place, to its points.
std::vector<Point2> displacements(const std::vector<Point2>& points, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  const double x = stream.next_unit();
  const Point2 parent{x, stream.next_unit()};
  std::vector<Point2> ways;
  for (const Point2& p : points) ways.push_back(unit_torus.difference(parent, p));
  return ways;
}

/// Uniform in [0, 1) if the law is: `share(squared distance)` is the law's distribution function.
void expect_law_of_displacement(const std::vector<Point2>& ways,
                                const std::function<double(double)>& share) {
  std::vector<std::int64_t> rings(20, 0), sectors(20, 0);
  const auto cell = [](double u) { return static_cast<std::size_t>(std::min(20.0 * u, 19.0)); };
  for (const Point2& way : ways) {
    ++rings[cell(share(squared_norm(way)))];
    ++sectors[cell(std::atan2(way.y, way.x) / (2.0 * std::numbers::pi) + 0.5)];
  }
  EXPECT_GT(uniformity_p_value(rings), least_p);
  EXPECT_GT(uniformity_p_value(sectors), least_p);
}

TEST(ThomasPointsLaw, DisplacementsAreNormal) {
  constexpr double sigma = 0.05;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto points =
        thomas(unit_torus, {.numbers = fixed_numbers(1, 10000), .sigma = sigma}, seed);
    ASSERT_EQ(points.size(), 10000u);
    expect_law_of_displacement(displacements(points, seed), [&](double squared) {
      return -std::expm1(-squared / (2.0 * sigma * sigma));
    });
  }
}

TEST(MaternPointsLaw, DisplacementsAreUniformInTheDisc) {
  constexpr double radius = 0.2;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto points =
        matern(unit_torus, {.numbers = fixed_numbers(1, 10000), .radius = radius}, seed);
    ASSERT_EQ(points.size(), 10000u);
    const auto ways = displacements(points, seed);
    for (const Point2& way : ways) ASSERT_LE(norm(way), radius * (1.0 + 1e-12));
    expect_law_of_displacement(ways, [&](double squared) { return squared / (radius * radius); });
  }
}

TEST(ThomasPoints, FixedNumbersAreExactOnTheTorus) {
  // The dissertation's example.
  const ThomasOptions options{.numbers = fixed_numbers(20, 20), .sigma = 0.05};
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    EXPECT_EQ(thomas(unit_torus, options, seed).size(), 400u);
}

/// Mean and variance of the number of points over many seeds must be those given.
void expect_count(const std::function<std::size_t(std::uint64_t)>& count, double mean,
                  double variance) {
  constexpr int runs = 4000;
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    const double excess = static_cast<double>(count(seed)) - mean;
    sum += excess;
    squares += excess * excess;
  }
  EXPECT_NEAR(sum / runs, 0.0, standard_errors * std::sqrt(variance / runs));
  // The counts are sums of many clusters, near enough to normal: relative error sqrt(2 / runs).
  constexpr double not_quite_normal = 1.2;
  EXPECT_NEAR(squares / runs / variance, 1.0,
              standard_errors * not_quite_normal * std::sqrt(2.0 / runs));
}

TEST(ThomasPointsLaw, NumbersFollowTheChosenLaws) {
  constexpr double parents = 12.0, offspring = 5.0;
  const auto count_with = [&](NumberLaw of_parents, NumberLaw of_offspring) {
    return [=](std::uint64_t seed) {
      const ClusterNumbers numbers{parents, of_parents, offspring, of_offspring};
      return thomas(unit_torus, {.numbers = numbers, .sigma = 0.1}, seed).size();
    };
  };
  constexpr double mean = parents * offspring;
  using enum NumberLaw;
  expect_count(count_with(poisson, poisson), mean, mean * (1.0 + offspring));
  expect_count(count_with(poisson, fixed), mean, mean * offspring);
  expect_count(count_with(fixed, poisson), mean, mean);
}

// Strips along the edges must hold as many points as their area asks for. With standard errors from
// the runs themselves: 4000 counts per strip.
void expect_no_thinning(const Window& window,
                        const std::function<std::vector<Point2>(std::uint64_t)>& pattern,
                        double intensity) {
  constexpr int runs = 4000;
  const std::pair<Rectangle, double> parts[] = {{{{0, 0}, {0.05, 1}}, 0.05},
                                                {{{0, 0}, {1, 0.05}}, 0.05},
                                                {{{0.95, 0.95}, {1, 1}}, 0.0025},
                                                {{{0, 0}, {2, 2}}, window.area()}};
  std::vector<double> sum(4, 0.0), squares(4, 0.0);
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    const auto points = pattern(seed);
    for (const Point2& p : points) ASSERT_TRUE(window.contains(p));
    for (std::size_t i = 0; i < 4; ++i) {
      const auto inside = [&](const Point2& p) { return parts[i].first.contains(p); };
      const auto count = static_cast<double>(std::ranges::count_if(points, inside));
      sum[i] += count;
      squares[i] += count * count;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double mean = sum[i] / runs, variance = squares[i] / runs - mean * mean;
    EXPECT_NEAR(mean, intensity * parts[i].second, standard_errors * std::sqrt(variance / runs));
  }
}

TEST(ThomasPointsLaw, AreNotThinnerAlongTheEdges) {
  for (const Window& window : {unit_plot, l_shape(), unit_torus})
    for (const NumberLaw law : {NumberLaw::poisson, NumberLaw::fixed}) {
      const ThomasOptions options{.numbers = {.parents = 10, .parents_law = law, .offspring = 4},
                                  .sigma = 0.1};
      expect_no_thinning(
          window, [&](std::uint64_t seed) { return thomas(window, options, seed); },
          40.0 / window.area());
    }
}

TEST(MaternPointsLaw, AreNotThinnerAlongTheEdges) {
  // A single parent of fixed number: 1.44 in the widened plot, which must not stay 1.
  const MaternOptions many{.numbers = {.parents = 10, .offspring = 4}, .radius = 0.2};
  const MaternOptions one{.numbers = fixed_numbers(1, 40), .radius = 0.1};
  for (const Window& window : {unit_plot, l_shape(), unit_torus})
    for (const MaternOptions& options : {many, one})
      expect_no_thinning(
          window, [&](std::uint64_t seed) { return matern(window, options, seed); },
          40.0 / window.area());
}

TEST(ClusterPointsLaw, ScaleWithTheWindow) {
  // Powers of two: not even rounding differs.
  const Window large = Window::torus({{0, 0}, {4, 4}});
  const ClusterNumbers numbers;
  auto thomas_large = thomas(large, {numbers, 0.5}, 3);
  auto matern_large = matern(large, {numbers, 0.5}, 3);
  for (auto* points : {&thomas_large, &matern_large})
    for (Point2& p : *points) p = 0.25 * p;
  EXPECT_EQ(thomas_large, thomas(unit_torus, {numbers, 0.125}, 3));
  EXPECT_EQ(matern_large, matern(unit_torus, {numbers, 0.125}, 3));
  EXPECT_NE(thomas_large, thomas(unit_torus, {numbers, 0.125}, 4));
}

TEST(ClusterPoints, WithoutSpreadStandOnTheirParents) {
  const auto points = thomas(unit_plot, {.numbers = fixed_numbers(3, 5), .sigma = 0.0}, 1);
  ASSERT_EQ(points.size(), 15u);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(points[i], points[i / 5 * 5]);
  EXPECT_EQ(points, matern(unit_plot, {.numbers = fixed_numbers(3, 5), .radius = 0.0}, 1));
  EXPECT_TRUE(thomas(unit_plot, {.numbers = {.parents = 0}}, 1).empty());
  EXPECT_TRUE(thomas(unit_plot, {.numbers = {.offspring = 0}}, 1).empty());
}

TEST(ClusterPoints, GoRoundTheTorusHoweverFar) {
  const Window torus = Window::torus({{-1, 3}, {1, 3.5}});
  const auto points = thomas(torus, {.numbers = fixed_numbers(20, 100), .sigma = 50.0}, 2);
  ASSERT_EQ(points.size(), 2000u);
  std::vector<std::int64_t> cells(16, 0);
  for (const Point2& p : points) {
    ASSERT_TRUE(torus.contains(p));
    ++cells.at(static_cast<std::size_t>(8.0 * (p.y - 3.0)) * 4 +
               static_cast<std::size_t>(2.0 * (p.x + 1.0)));
  }
  EXPECT_GT(uniformity_p_value(cells), least_p);
}

TEST(ClusterPoints, RefuseOptionsOutOfRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {-1.0, infinity, std::nan("")}) {
    EXPECT_THROW(thomas(unit_torus, {.numbers = {.parents = wrong}}, 1), ContractViolation);
    EXPECT_THROW(thomas(unit_torus, {.numbers = {.offspring = wrong}}, 1), ContractViolation);
    EXPECT_THROW(thomas(unit_torus, {.sigma = wrong}, 1), ContractViolation);
    EXPECT_THROW(matern(unit_torus, {.radius = wrong}, 1), ContractViolation);
  }
  EXPECT_THROW(thomas(unit_torus, {.numbers = fixed_numbers(2.5, 2)}, 1), ContractViolation);
  EXPECT_THROW(thomas(unit_torus, {.numbers = fixed_numbers(2, 2.5)}, 1), ContractViolation);
}

TEST(ClusterPoints, TooManyAreAnInputError) {
  EXPECT_THROW(thomas(unit_torus, {.numbers = fixed_numbers(20000, 20000)}, 1), InputError);
  EXPECT_THROW(thomas(unit_torus, {.numbers = {.parents = 1e-9, .offspring = 1e12}}, 1),
               InputError);
  EXPECT_THROW(thomas(unit_plot, {.sigma = 1e5}, 1), InputError);
  EXPECT_THROW(matern(unit_plot, {.radius = 1e160}, 1), InputError);
}

}  // namespace
}  // namespace phytobench
