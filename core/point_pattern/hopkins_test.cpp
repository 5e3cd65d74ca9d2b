// SPDX-License-Identifier: MIT
#include "core/point_pattern/hopkins.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/point_pattern/cluster_patterns.hpp"
#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/lloyd.hpp"
#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"

namespace phytobench {
namespace {

using test_patterns::Points;
using test_patterns::Sample;
using test_patterns::unit_plot;
using test_patterns::unit_torus;

TEST(Hopkins, LatticesHaveTheirClosedForms) {
  const Rectangle box{{0, 0}, {12, 12}};
  const HopkinsIndex s = hopkins_exact(square_lattice(box, 12, 12), Window::torus(box));
  EXPECT_NEAR(s.mean_ratio, 0.38259785823210635, 1e-12);
  EXPECT_NEAR(s.squared_ratio, 1.0 / 6, 1e-12);
  const Rectangle wide{{0, 0}, {12, 14 * std::sqrt(3.0) / 2}};
  const HopkinsIndex t = hopkins_exact(triangular_lattice(wide, 12, 14), Window::torus(wide));
  EXPECT_NEAR(t.mean_ratio, 0.3510211148792663, 1e-12);
  EXPECT_NEAR(t.squared_ratio, 5.0 / 36, 1e-12);
}

TEST(Hopkins, HasDefinedAnswersWhereThereIsNothingToCompare) {
  CounterStream stream(1, 0);
  for (const Points& points : {Points{}, Points{{0.5, 0.5}}}) {
    EXPECT_TRUE(std::isnan(hopkins_exact(points, unit_plot).mean_ratio));
    EXPECT_TRUE(std::isnan(hopkins_sampled(points, unit_plot, 10, stream).squared_ratio));
  }
  EXPECT_TRUE(std::isinf(hopkins_exact(Points(5, {0.25, 0.5}), unit_plot).mean_ratio));
}

TEST(HopkinsLaw, SampledConvergesToExact) {
  for (const Window& window : {unit_torus, unit_plot, test_patterns::l_shape()}) {
    const Points points = test_patterns::clustered_points(window, 300, 0.1, 2);
    const HopkinsIndex exact = hopkins_exact(points, window);
    Sample mean, squared;
    CounterStream stream(2, 0);
    for (int k = 0; k < 60; ++k) {
      const HopkinsIndex h = hopkins_sampled(points, window, 2000, stream);
      mean.add(h.mean_ratio);
      squared.add(h.squared_ratio);
    }
    EXPECT_LT(std::abs(mean.errors_above(exact.mean_ratio)), test_patterns::chance);
    EXPECT_LT(std::abs(squared.errors_above(exact.squared_ratio)), test_patterns::chance);
    EXPECT_LT(mean.error(), 0.01 * exact.mean_ratio);  // the test can fail
  }
}

TEST(HopkinsLaw, DoesNotDependOnOrderOrScale) {
  for (const double scale : {0x1p-40, 0x1p40}) {
    Points points = test_patterns::random_points(unit_plot, 400, 5);
    const HopkinsIndex first = hopkins_exact(points, unit_plot);
    std::reverse(points.begin(), points.end());
    EXPECT_NEAR(hopkins_exact(points, unit_plot).mean_ratio / first.mean_ratio, 1.0, 1e-13);
    for (Point2& p : points) p = scale * p;
    const HopkinsIndex scaled = hopkins_exact(points, Window::rectangle({{0, 0}, {scale, scale}}));
    EXPECT_NEAR(scaled.mean_ratio / first.mean_ratio, 1.0, 1e-12);
    EXPECT_NEAR(scaled.squared_ratio / first.squared_ratio, 1.0, 1e-12);
  }
}

/// [Alsweis] sec. 2.4.1: H = 1 random, above clustered, below regular.
TEST(HopkinsLaw, TellsClustersFromLattices) {
  CounterStream stream(7, 0);
  using enum NumberLaw;
  const Points clusters = thomas_points(unit_torus, {{20, fixed, 20, fixed}, 0.05}, stream);
  EXPECT_GT(hopkins_exact(clusters, unit_torus).mean_ratio, 1.5);
  EXPECT_LT(hopkins_exact(jittered_lattice(test_patterns::unit_square, 20, 20, stream), unit_torus)
                .mean_ratio,
            0.85);
}

TEST(ExpectedNearestDistance, OnATorusHasTheRatiosOfExpectations) {
  const auto ratio = [](const Window& window, std::size_t n) {
    return expected_nearest_distance(window, n) / expected_nearest_distance(window, n - 1);
  };
  EXPECT_NEAR(ratio(unit_torus, 2), 0.788148, 1e-6);
  EXPECT_NEAR(ratio(unit_torus, 3), 0.855589, 1e-6);
  EXPECT_NEAR(ratio(unit_torus, 4), 0.888652, 1e-6);
  EXPECT_NEAR(ratio(unit_torus, 5), 0.909052, 1e-6);
  for (const std::size_t n : {10u, 100u, 10'000u})
    EXPECT_NEAR(ratio(unit_torus, n),
                2.0 * static_cast<double>(n) / (2.0 * static_cast<double>(n) + 1), 2e-8)
        << n;
  // Mean distance of two points on the unit torus: (sqrt 2 + asinh 1) / 6, as a square's centre.
  EXPECT_NEAR(expected_nearest_distance(unit_torus, 1), 0.38259785823210635, 1e-10);
}

TEST(ExpectedNearestDistance, IsTheMeanOfRandomPatterns) {
  for (const Window& window : {unit_torus, unit_plot, Window::torus({{0, 0}, {3, 0.4}}),
                               Window::rectangle({{0, 0}, {2, 1}})}) {
    Sample distance;
    for (std::uint64_t k = 0; k < 3000; ++k)
      distance.add(clark_evans(test_patterns::random_points(window, 30, k), window).mean_distance);
    // Donnelly's is an approximation: right to a fraction of a percent.
    const double slack = window.kind() == WindowKind::torus ? 0.0 : 2e-3;
    const double expected = expected_nearest_distance(window, 29);
    EXPECT_NEAR(distance.mean(), expected, 4 * distance.error() + slack * expected);
    EXPECT_LT(4 * distance.error() + slack * expected, 0.012 * expected);
  }
}

TEST(ClarkEvans, PValuesOfRandomPatternsAreNearlyUniform) {
  for (const Window& window : {unit_torus, unit_plot}) {
    std::vector<double> p_values;
    for (std::uint64_t k = 0; k < 1000; ++k)
      p_values.push_back(clark_evans(test_patterns::random_points(window, 60, k), window).p_value);
    EXPECT_GT(kolmogorov_uniformity_p_value(p_values), 1e-3);
  }
}

TEST(ClarkEvans, CountsEdgesAndTellsClustersFromLattices) {
  const Points lattice = square_lattice(test_patterns::unit_square, 10, 10);
  EXPECT_NEAR(clark_evans(lattice, unit_torus).naive_ratio, 2.0, 1e-12);
  EXPECT_LT(clark_evans(lattice, unit_torus).p_value, 1e-12);
  EXPECT_GT(clark_evans(lattice, unit_torus).z, 10);
  const ClarkEvansIndex clusters =
      clark_evans(test_patterns::clustered_points(unit_plot, 200, 0.05, 1), unit_plot);
  EXPECT_LT(clusters.z, -5);
  EXPECT_LT(clusters.ratio, clusters.naive_ratio);  // edges make distances longer
  EXPECT_TRUE(std::isnan(clark_evans(Points{{0, 0}}, unit_plot).ratio));
  // No normal law in a strip: rather none than a wrong one.
  for (const Window& strip :
       {Window::rectangle({{0, 0}, {100, 1}}), Window::torus({{0, 0}, {1, 1e6}})}) {
    const ClarkEvansIndex index = clark_evans(test_patterns::random_points(strip, 30, 1), strip);
    EXPECT_TRUE(std::isnan(index.p_value));
    EXPECT_FALSE(std::isnan(index.ratio));
  }
}

TEST(LloydLaw, EnergyNeverRisesAndApproachesTheTriangularLattice) {
  for (const Window& window : {unit_torus, unit_plot, test_patterns::l_shape()}) {
    Points points = test_patterns::random_points(window, 150, 3);
    double last = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 40; ++k) {
      const LloydStep step = lloyd_step(points, window);
      EXPECT_LE(step.energy, last * (1 + 1e-12));
      last = step.energy;
      points = step.points;
      for (const Point2& p : points) ASSERT_TRUE(window.contains(p));
    }
    EXPECT_GT(150 * last,
              5 / (18 * std::sqrt(3.0)) * (window.kind() == WindowKind::torus ? 1 : 0.9));
    EXPECT_LT(150 * last, 0.18);
  }
}

TEST(Lloyd, LeavesLatticesWhereTheyAre) {
  const Rectangle box{{0, 0}, {6, 5}};
  const Points points = square_lattice(box, 6, 5);
  for (const Window& window : {Window::torus(box), Window::rectangle(box)}) {
    const Points after = lloyd_points(points, window, 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_LT(norm(window.difference(points[i], after[i])), 1e-13);
  }
}

}  // namespace
}  // namespace phytobench
