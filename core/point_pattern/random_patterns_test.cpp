// SPDX-License-Identifier: MIT
#include "core/point_pattern/random_patterns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

using test_patterns::least_p;
using test_patterns::standard_errors;
using test_patterns::unit_torus;

/// An L of three unit squares, away from the origin.
Window distant_l_shape() {
  return Window::polygon({{5, 7}, {7, 7}, {7, 8}, {6, 8}, {6, 9}, {5, 9}});
}

std::vector<Point2> outwards(double intensity, double radius, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  return poisson_points_outwards(intensity, radius, stream);
}

std::vector<Point2> poisson(const Window& window, double intensity, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  return poisson_points(window, intensity, stream);
}

/// Whether counts have mean and variance `expected`, as Poisson's have.
void expect_poisson_moments(const std::vector<double>& counts, double expected) {
  const auto n = static_cast<double>(counts.size());
  double sum = 0.0, squares = 0.0;
  for (const double count : counts) {
    sum += count - expected;
    squares += (count - expected) * (count - expected);
  }
  EXPECT_NEAR(sum / n, 0.0, standard_errors * std::sqrt(expected / n));
  // The fourth central moment of the law is 3 mean^2 + mean.
  EXPECT_NEAR(squares / n, expected,
              standard_errors * std::sqrt((2.0 * expected * expected + expected) / n));
}

TEST(UniformPoints, AreAsManyAsAskedForAndInside) {
  for (const Window& window :
       {unit_torus, Window::rectangle({{-3, 2}, {5, 2.5}}), distant_l_shape()})
    for (const std::size_t count : {0u, 1u, 500u}) {
      CounterStream stream(1, 0);
      const auto points = uniform_points(window, count, stream);
      ASSERT_EQ(points.size(), count);
      for (const Point2& p : points) ASSERT_TRUE(window.contains(p));
    }
}

TEST(UniformPointsLaw, FallIntoEqualAreasEquallyOften) {
  CounterStream stream(1, 0);
  std::vector<std::int64_t> cells(64, 0), squares(3, 0);
  for (const Point2& p : uniform_points(unit_torus, 20000, stream))
    ++cells.at(static_cast<std::size_t>(8.0 * p.y) * 8 + static_cast<std::size_t>(8.0 * p.x));
  EXPECT_GT(uniformity_p_value(cells), least_p);
  for (const Point2& p : uniform_points(distant_l_shape(), 20000, stream))
    ++squares[p.x > 6.0 ? 1 : p.y > 8.0 ? 2 : 0];
  EXPECT_GT(uniformity_p_value(squares), least_p);
}

TEST(UniformPointsLaw, MorePointsKeepTheFirstOnes) {
  CounterStream one(4, 2), other(4, 2), third(5, 2);
  const auto few = uniform_points(distant_l_shape(), 100, one);
  auto many = uniform_points(distant_l_shape(), 200, other);
  EXPECT_NE(few, uniform_points(distant_l_shape(), 100, third));
  many.resize(100);
  EXPECT_EQ(few, many);
}

TEST(UniformPoints, TooManyAreAnInputError) {
  CounterStream stream(1, 0);
  EXPECT_THROW(uniform_points(unit_torus, 200'000'001, stream), InputError);
}

TEST(PoissonOutwardsLaw, ComeSortedAndMoreKeepTheFirstOnes) {
  const auto few = outwards(3.0, 4.0, 1);
  auto many = outwards(3.0, 6.0, 1);
  ASSERT_GT(many.size(), few.size());
  EXPECT_GT(norm(many[few.size()]), 4.0);
  EXPECT_LE(norm(few.back()), 4.0);
  EXPECT_TRUE(std::is_sorted(many.begin(), many.end(), [](const Point2& a, const Point2& b) {
    return squared_norm(a) < squared_norm(b) * (1.0 - 1e-12);
  }));
  many.resize(few.size());
  EXPECT_EQ(few, many);
}

// [Alsweis] eq. 2.7: the area of the circle through the i-th point times the intensity is a sum of
// i exponential gaps, Gamma(i, 1); E|P_i| = Gamma(i + 1/2) / (Gamma(i) sqrt(pi intensity)).
TEST(PoissonOutwardsLaw, AreasOfCirclesThroughPointsHaveTheGammaLaw) {
  constexpr int runs = 20000;
  constexpr double intensity = 4.0;
  for (const std::size_t i : {1u, 2u, 5u, 10u}) {
    const auto shape = static_cast<double>(i);
    double sum = 0.0, squares = 0.0, distances = 0.0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
      // 38 points are expected: fewer than ten once in 10^8 runs.
      const double distance = norm(outwards(intensity, 1.75, seed).at(i - 1));
      const double q = std::numbers::pi * intensity * distance * distance;
      sum += q - shape;
      squares += (q - shape) * (q - shape);
      distances += distance;
    }
    EXPECT_NEAR(sum / runs, 0.0, standard_errors * std::sqrt(shape / runs)) << i;
    // Fourth central moment of the Gamma law: 3 i^2 + 6 i.
    const double error = std::sqrt((2.0 * shape * shape + 6.0 * shape) / runs);
    EXPECT_NEAR(squares / runs, shape, standard_errors * error) << i;
    const double mean_distance = std::exp(std::lgamma(shape + 0.5) - std::lgamma(shape)) /
                                 std::sqrt(std::numbers::pi * intensity);
    const double variance = shape / (std::numbers::pi * intensity) - mean_distance * mean_distance;
    EXPECT_NEAR(distances / runs, mean_distance, standard_errors * std::sqrt(variance / runs)) << i;
  }
}

TEST(PoissonOutwardsLaw, CountsInDiscsAndSquaresHaveThePoissonLaw) {
  std::vector<double> in_disc, in_square;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const auto points = outwards(1.0, 5.0, seed);
    in_disc.push_back(static_cast<double>(points.size()));
    const auto off_centre = [](const Point2& p) {
      return Rectangle{{1.0, -1.0}, {3.0, 1.0}}.contains(p);
    };
    in_square.push_back(static_cast<double>(std::ranges::count_if(points, off_centre)));
  }
  expect_poisson_moments(in_disc, 25.0 * std::numbers::pi);
  expect_poisson_moments(in_square, 4.0);
}

TEST(PoissonOutwardsLaw, DirectionsAreUniformAndKnowNothingOfDistances) {
  const auto points = outwards(1.0, 80.0, 3);
  std::vector<std::int64_t> inner(16, 0), outer(16, 0);
  for (const Point2& p : points) {
    const double turn = std::atan2(p.y, p.x) / (2.0 * std::numbers::pi) + 0.5;
    auto& sectors = squared_norm(p) < 3200.0 ? inner : outer;
    ++sectors[std::min<std::size_t>(static_cast<std::size_t>(16.0 * turn), 15)];
  }
  EXPECT_GT(uniformity_p_value(inner), least_p);
  EXPECT_GT(uniformity_p_value(outer), least_p);
}

TEST(PoissonOutwards, FollowsTheEquationsDrawByDraw) {
  CounterStream numbers(8, 1), stream(8, 1);
  const auto points = poisson_points_outwards(2.0, 3.0, stream);
  double q = 0.0;
  for (const Point2& p : points) {
    q -= std::log(1.0 - numbers.next_unit());
    const double angle = 2.0 * std::numbers::pi * numbers.next_unit();
    const double distance = std::sqrt(q / (std::numbers::pi * 2.0));
    EXPECT_NEAR(p.x, distance * std::cos(angle), 1e-12);
    EXPECT_NEAR(p.y, distance * std::sin(angle), 1e-12);
  }
  numbers.next_unit();  // the gap that led out of the circle
  EXPECT_EQ(numbers.next_unit(), stream.next_unit());
}

TEST(PoissonPointsLaw, CountsHaveThePoissonLawInAnyWindow) {
  const Window narrow = Window::rectangle({{-3, 2}, {5, 2.5}});
  for (const Window& window : {Window::torus({{2, 2}, {4, 4}}), narrow, distant_l_shape()}) {
    std::vector<double> counts;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
      const auto points = poisson(window, 5.0, seed);
      counts.push_back(static_cast<double>(points.size()));
      for (const Point2& p : points) ASSERT_TRUE(window.contains(p));
    }
    expect_poisson_moments(counts, 5.0 * window.area());
  }
}

TEST(PoissonPointsLaw, FallIntoEqualAreasEquallyOften) {
  std::vector<std::int64_t> cells(64, 0);
  for (const Point2& p : poisson(unit_torus, 20000.0, 11))
    ++cells.at(static_cast<std::size_t>(8.0 * p.y) * 8 + static_cast<std::size_t>(8.0 * p.x));
  EXPECT_GT(uniformity_p_value(cells), least_p);
}

TEST(PoissonPointsLaw, ScaleWithTheWindow) {
  // Powers of two: not even rounding differs.
  const auto small = poisson(unit_torus, 256.0, 5);
  auto large = poisson(Window::torus({{0, 0}, {4, 4}}), 16.0, 5);
  for (Point2& p : large) p = 0.25 * p;
  EXPECT_EQ(small, large);
  EXPECT_NE(small, poisson(unit_torus, 256.0, 6));
}

TEST(PoissonPoints, RefusesWhatIsNoIntensityOrRadius) {
  CounterStream stream(1, 0);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(poisson_points(unit_torus, wrong, stream), ContractViolation) << wrong;
    EXPECT_THROW(poisson_points_outwards(1.0, wrong, stream), ContractViolation) << wrong;
  }
  EXPECT_THROW(poisson_points(unit_torus, 1e9, stream), InputError);
  EXPECT_THROW(poisson_points_outwards(1.0, 1e5, stream), InputError);
}

}  // namespace
}  // namespace phytobench
