// SPDX-License-Identifier: MIT
// The test of randomness by the Hopkins index: it holds its level, finds what is there, and the
// textbook's shortcut does not hold its level.
#include "core/point_pattern/hopkins_null.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/point_pattern/cluster_patterns.hpp"
#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/monte_carlo.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/f_distribution.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"

namespace phytobench {
namespace {

using test_patterns::Points;
using test_patterns::unit_plot;
using test_patterns::unit_torus;

double p_value(const Points& points, const Window& window, const HopkinsNull& null) {
  return rank_p_value(hopkins_exact(points, window).mean_ratio, null.mean_ratio, Tail::both);
}

TEST(HopkinsNullSlow, PValuesOfRandomPatternsAreUniform) {
  constexpr std::size_t points = 50;
  for (const Window& window : {unit_plot, unit_torus, test_patterns::l_shape()}) {
    std::vector<double> p_values;
    const std::uint64_t runs = window.kind() == WindowKind::polygon ? 300 : 1000;
    for (std::uint64_t k = 0; k < runs; ++k) {
      // Each pattern among peers of its own: shared ones would make p-values depend on each other.
      const HopkinsNull null = hopkins_null(window, points, {.simulations = 39, .seed = 1000 + k});
      p_values.push_back(p_value(random_pattern(window, points, 7, k), window, null));
    }
    // Steps of 1/20; the test for continuous values is too strict then, if anything.
    std::vector<double> spread = p_values;
    CounterStream stream(4, 0);
    for (double& p : spread) p -= 0.05 * stream.next_unit();
    EXPECT_GT(kolmogorov_uniformity_p_value(spread), 1e-4) << name_of(window.kind());
    const auto below =
        std::count_if(p_values.begin(), p_values.end(), [](double p) { return p <= 0.05; });
    EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(runs), 0.05,
                4 * std::sqrt(0.05 * 0.95 / static_cast<double>(runs)));
  }
}

/// A window that is guessed as the bounding box has points on all of its sides: so must the peers.
TEST(HopkinsNullLaw, LevelIsKeptInAGuessedWindow) {
  constexpr int runs = 1000;
  for (const std::size_t points : {3u, 20u}) {
    int rejected = 0, without_care = 0;
    for (std::uint64_t k = 0; k < runs; ++k) {
      const Points pattern = random_pattern(unit_plot, points, 13, k);
      Rectangle box{pattern[0], pattern[0]};
      for (const Point2& p : pattern) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
      }
      const Window guessed = Window::rectangle(box);
      const auto null = [&](bool fills_box) {
        return hopkins_null(guessed, points,
                            {.simulations = 39, .seed = 1000 + k, .fills_box = fills_box});
      };
      rejected += p_value(pattern, guessed, null(true)) <= 0.05;
      without_care += p_value(pattern, guessed, null(false)) <= 0.05;
    }
    const double error = std::sqrt(0.05 * 0.95 / runs);
    EXPECT_NEAR(static_cast<double>(rejected) / runs, 0.05, 4 * error) << points;
    if (points == 3) {
      EXPECT_GT(static_cast<double>(without_care) / runs, 0.05 + 4 * error);
    }
  }
}

/// Neighbouring distances depend on each other: with as many places as points the F distribution
/// of 2n and 2n degrees of freedom rejects random patterns far too often.
TEST(HopkinsNullLaw, TheFTestWithAsManyPlacesAsPointsDoesNotHoldItsLevel) {
  constexpr std::size_t points = 50;
  constexpr int runs = 2000;
  const double low = f_quantile(0.025, {2.0 * points, 2.0 * points});
  const double high = f_quantile(0.975, {2.0 * points, 2.0 * points});
  int rejected = 0;
  CounterStream stream(3, 0);
  for (std::uint64_t k = 0; k < runs; ++k) {
    const Points pattern = random_pattern(unit_plot, points, 9, k);
    const double a = 1.0 / hopkins_sampled(pattern, unit_plot, points, stream).squared_ratio;
    rejected += a < low || a > high;
  }
  const double rate = static_cast<double>(rejected) / runs;
  EXPECT_GT(rate, 0.12);  // by notes of others about 0.17
  EXPECT_LT(rate, 0.22);
}

TEST(HopkinsNull, FindsClustersAndLattices) {
  const HopkinsNull null = hopkins_null(unit_torus, 100, {.simulations = 199});
  int clusters = 0, lattices = 0;
  constexpr int runs = 40;
  for (int k = 0; k < runs; ++k) {
    CounterStream stream(11, static_cast<std::uint64_t>(k));
    Points cluster =
        thomas_points(unit_torus, {{20, NumberLaw::fixed, 5, NumberLaw::fixed}, 0.03}, stream);
    clusters += p_value(cluster, unit_torus, null) <= 0.05;
    lattices += p_value(jittered_lattice(test_patterns::unit_square, 10, 10, stream), unit_torus,
                        null) <= 0.05;
  }
  EXPECT_EQ(clusters, runs);
  EXPECT_EQ(lattices, runs);
}

TEST(HopkinsNullSlow, ScalesItsSpreadForLargePatterns) {
  const HopkinsNull small =
      hopkins_null(unit_torus, 6400, {.simulations = 300, .seed = 1, .most_points = 400});
  const HopkinsNull full =
      hopkins_null(unit_torus, 6400, {.simulations = 300, .seed = 2, .most_points = 6400});
  EXPECT_EQ(small.points_per_pattern, 400u);
  const auto width = [](const std::vector<double>& values) {
    const auto band = central_95(values);
    return band[1] - band[0];
  };
  EXPECT_NEAR(width(small.mean_ratio) / width(full.mean_ratio), 1.0, 0.25);
  EXPECT_NEAR(central_95(small.mean_ratio)[0], central_95(full.mean_ratio)[0], 0.004);
  EXPECT_NEAR(central_95(small.squared_ratio)[1], central_95(full.squared_ratio)[1], 0.008);
}

TEST(HopkinsNull, AStripStaysAStripWhenItIsCut) {
  const Window strip = Window::rectangle({{0, 0}, {2000, 1}});
  const HopkinsNull small =
      hopkins_null(strip, 4000, {.simulations = 300, .seed = 1, .most_points = 400});
  const HopkinsNull full =
      hopkins_null(strip, 4000, {.simulations = 300, .seed = 2, .most_points = 4000});
  const auto width = [](const std::vector<double>& values) {
    const auto band = central_95(values);
    return band[1] - band[0];
  };
  EXPECT_NEAR(width(small.mean_ratio) / width(full.mean_ratio), 1.0, 0.25);
}

TEST(HopkinsNull, DoesNotDependOnThreads) {
  const HopkinsNull one = hopkins_null(unit_plot, 60, {.simulations = 40, .seed = 5});
  const HopkinsNull three =
      hopkins_null(unit_plot, 60, {.simulations = 40, .seed = 5, .threads = 3});
  EXPECT_EQ(one.mean_ratio, three.mean_ratio);
  EXPECT_EQ(one.squared_ratio, three.squared_ratio);
}

}  // namespace
}  // namespace phytobench
