// SPDX-License-Identifier: MIT
#include "core/point_pattern/dart_throwing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

/// Windows of area 1 or a little more: with and without edges, low, bent, away from the origin.
const std::vector<Window>& windows() {
  static const std::vector<Window> all{
      unit_torus,
      Window::torus({{-7, 3}, {-3, 3.25}}),
      Window::rectangle({{2, 2}, {3, 3}}),
      Window::rectangle({{0, 0}, {10, 0.1}}),
      Window::polygon({{0, 0}, {2, 0}, {2, 0.3}, {0.4, 0.4}, {0.3, 2}, {0, 2}}),
      Window::polygon({{0, 0}, {3, 3}, {3.2, 3}, {0.2, 0}}),
  };
  return all;
}

std::vector<Point2> darts(const Window& window, double distance, std::size_t most,
                          std::uint64_t seed) {
  CounterStream stream(seed, 0);
  return dart_points(window, distance, most, stream);
}

double nearest_distance(const Window& window, const std::vector<Point2>& points,
                        const Point2& place) {
  double best = std::numeric_limits<double>::max();
  for (const Point2& p : points) best = std::min(best, squared_norm(window.difference(p, place)));
  return std::sqrt(best);
}

/// No two points nearer than the distance, all inside.
void expect_apart(const Window& window, const std::vector<Point2>& points, double distance) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_TRUE(window.contains(points[i]));
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GE(norm(window.difference(points[j], points[i])), distance * (1.0 - 1e-15));
  }
}

TEST(DartPointsLaw, KeepTheirDistanceAlsoAcrossTheTorus) {
  for (const Window& window : windows())
    for (const double distance : {0.04, 0.11, 0.5})
      for (const std::size_t most : {std::size_t{20}, std::size_t{400}, until_saturated})
        expect_apart(window, darts(window, distance, most, 1), distance);
}

TEST(DartPointsLaw, LeaveNoRoomForAnotherWhenSaturated) {
  for (const Window& window : windows())
    for (const double distance : {0.05, 0.11, 0.5}) {
      const auto points = darts(window, distance, until_saturated, 2);
      const Rectangle& box = window.bounding_box();
      constexpr int steps = 250;
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
          const Point2 place{box.low.x + box.width() * i / steps,
                             box.low.y + box.height() * j / steps};
          if (window.contains(place))
            ASSERT_LE(nearest_distance(window, points, place), distance * (1.0 + 1e-9));
        }
      // Corners are the last places that are reached.
      for (const Point2& corner : window.corners())
        EXPECT_LE(nearest_distance(window, points, corner), distance * (1.0 + 1e-9));
    }
}

TEST(DartPoints, StopAtTheMostThatAreAskedFor) {
  for (const Window& window : windows()) {
    const std::size_t all = darts(window, 0.05, until_saturated, 3).size();
    for (const std::size_t most : {0u, 1u, 2u, 50u, 200u})
      EXPECT_EQ(darts(window, 0.05, most, 3).size(), most);
    // More than fit: the number itself is random, a few deviations of 0.056 per root of a point.
    const auto fitted = static_cast<double>(darts(window, 0.05, 2 * all, 3).size());
    EXPECT_NEAR(fitted, static_cast<double>(all), 8.0 * 0.3 * std::sqrt(fitted));
  }
}

TEST(DartPoints, OfAGreatDistanceAreOne) {
  for (const Window& window : windows())
    EXPECT_EQ(darts(window, 20.0, until_saturated, 1).size(), 1u);
}

TEST(DartPointsLaw, WithoutDistanceAreUniform) {
  std::vector<std::int64_t> cells(64, 0);
  for (const Point2& p : darts(unit_torus, 0.0, 20000, 4))
    ++cells.at(static_cast<std::size_t>(8.0 * p.y) * 8 + static_cast<std::size_t>(8.0 * p.x));
  EXPECT_GT(uniformity_p_value(cells), least_p);
}

TEST(DartPoints, WithATinyDistanceNeedNoMoreMemoryThanTheirNumber) {
  EXPECT_EQ(darts(unit_torus, 1e-7, 1000, 4).size(), 1000u);
  EXPECT_EQ(darts(windows()[5], 1e-7, 1000, 4).size(), 1000u);
}

TEST(DartPointsLaw, AreAFunctionOfTheStreamAndScaleWithTheWindow) {
  // Powers of two: not even rounding differs.
  const auto small = darts(unit_torus, 0.0625, until_saturated, 5);
  auto large = darts(Window::torus({{0, 0}, {4, 4}}), 0.25, until_saturated, 5);
  for (Point2& p : large) p = 0.25 * p;
  EXPECT_EQ(small, large);
  EXPECT_EQ(small, darts(unit_torus, 0.0625, until_saturated, 5));
  EXPECT_NE(small, darts(unit_torus, 0.0625, until_saturated, 6));
}

// The second point is uniform in what the first leaves free: the ring from 0.4 to 0.5 holds
// pi (0.5^2 - 0.4^2) of 1 - pi 0.4^2.
TEST(DartPointsLaw, SecondPointIsUniformInTheFreeGround) {
  constexpr int runs = 20000;
  const double share = std::numbers::pi * 0.09 / (1.0 - std::numbers::pi * 0.16);
  for (const std::size_t most : {std::size_t{2}, std::size_t{3}, until_saturated}) {
    int in_ring = 0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
      const auto points = darts(unit_torus, 0.4, most, seed);
      in_ring += norm(unit_torus.difference(points.at(0), points.at(1))) < 0.5;
    }
    EXPECT_NEAR(static_cast<double>(in_ring) / runs, share,
                standard_errors * std::sqrt(share * (1.0 - share) / runs));
  }
}

/// Dart throwing as defined: at the whole window, until one dart after the other has missed.
std::vector<Point2> patient_darts(const Window& window, double distance, CounterStream& stream) {
  constexpr int patience = 10000;  // a gap of a thousandth is overlooked once in 20 000 times
  std::vector<Point2> points;
  for (int missed = 0; missed < patience; ++missed) {
    const Point2 dart = window.random_point(stream);
    if (!points.empty() && nearest_distance(window, points, dart) < distance) continue;
    points.push_back(dart);
    missed = 0;
  }
  return points;
}

TEST(DartPointsSlow, HaveTheNumbersOfPatientDartThrowing) {
  constexpr int runs = 1500;
  const Window bent = Window::polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}});
  for (const Window& window : {unit_torus, Window::rectangle({{0, 0}, {1, 0.5}}), bent}) {
    std::map<std::size_t, std::pair<int, int>> runs_with;  // number of points: ours, theirs
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
      CounterStream stream(seed, 1);
      ++runs_with[darts(window, 0.3, until_saturated, seed).size()].first;
      ++runs_with[patient_darts(window, 0.3, stream).size()].second;
    }
    for (const auto& [points, count] : runs_with) {
      const double pooled = (count.first + count.second) / (2.0 * runs);
      EXPECT_NEAR(count.first, count.second,
                  standard_errors * std::sqrt(2.0 * runs * pooled * (1.0 - pooled)) + 3.0)
          << points << " points";
    }
  }
}

// Jammed discs cover 0.54707 of the plane; their diameter is the distance.
TEST(DartPointsOracle, JamAtTheKnownDensity) {
  constexpr double distance = 0.005, jamming_density = 4.0 * 0.54707 / std::numbers::pi;
  const auto points = static_cast<double>(darts(unit_torus, distance, until_saturated, 8).size());
  // One pattern's deviation, measured at distances 0.01 and 0.03: 0.26 distance.
  const double error = 0.26 * distance * jamming_density;
  EXPECT_NEAR(points * distance * distance, jamming_density, standard_errors * error);
}

// A torus of no height is Renyi's street, on which cars of length 1 park until none fits:
// 0.7475979 per length, with variance 0.0381564.
TEST(DartPointsOracle, ParkLikeRenyisCars) {
  constexpr double car = 1e-4;
  constexpr int runs = 20;
  const Window street = Window::torus({{0, 0}, {1, 1e-9}});
  double parked = 0.0;
  for (std::uint64_t seed = 0; seed < runs; ++seed)
    parked += static_cast<double>(darts(street, car, until_saturated, seed).size());
  EXPECT_NEAR(parked * car / runs, 0.7475979, standard_errors * std::sqrt(0.0381564 * car / runs));
}

TEST(DartPoints, RefuseWhatIsNoDistanceAndTooManyPoints) {
  for (const double wrong : {-0.1, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(darts(unit_torus, wrong, 10, 1), ContractViolation);
  EXPECT_THROW(darts(unit_torus, 0.0, until_saturated, 1), InputError);
  EXPECT_THROW(darts(unit_torus, 1e-6, until_saturated, 1), InputError);
  EXPECT_THROW(darts(unit_torus, 1e-6, 300'000'000, 1), InputError);
}

TEST(DartPoints, RefuseAPolygonTooThinToHit) {
  const Window sliver = Window::polygon({{0, 0}, {1, 1}, {1, 1 + 1e-12}, {0, 1e-12}});
  EXPECT_THROW(darts(sliver, 0.1, until_saturated, 1), InputError);
}

}  // namespace
}  // namespace phytobench
