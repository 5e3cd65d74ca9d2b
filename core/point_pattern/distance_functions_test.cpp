// SPDX-License-Identifier: MIT
#include "core/point_pattern/distance_functions.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/edge_distance.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Values = std::vector<double>;

constexpr double distribution_rounding = 1e-12;
const std::vector<DistanceCorrection> all_distance_corrections{
    DistanceCorrection::none, DistanceCorrection::border, DistanceCorrection::kaplan_meier};

TEST(DistanceDistribution, IsTheOneByHand) {
  using enum DistanceCorrection;
  // Deaths at 1 and 3, censored at 1 and 2, both at 3.
  const Values measured{1.0, 5.0, 9.0, 3.0, 7.0}, to_edge{4.0, 1.0, 2.0, 3.0, 3.0};
  const Values asked{0.5, 1.0, 2.0, 2.5, 3.0, 3.5, 9.0};
  EXPECT_EQ(distance_distribution(measured, to_edge, asked, none),
            (Values{0.0, 0.2, 0.2, 0.2, 0.4, 0.4, 1.0}));
  const Values reduced = distance_distribution(measured, to_edge, asked, border);
  EXPECT_EQ(Values(reduced.begin(), reduced.begin() + 6),
            (Values{0.0, 0.2, 0.25, 1.0 / 3.0, 2.0 / 3.0, 1.0}));
  EXPECT_TRUE(std::isnan(reduced[6]));  // nobody is that far inside
  const Values survival = distance_distribution(measured, to_edge, asked, kaplan_meier);
  const Values expected{0.0, 0.2, 0.2, 0.2, 0.6, 0.6, 0.6};  // 1 - 0.8 and 1 - 0.8 / 2
  for (std::size_t k = 0; k < asked.size(); ++k)
    EXPECT_NEAR(survival[k], expected[k], distribution_rounding);
}

TEST(DistanceDistributionLaw, WithoutABorderAllCorrectionsAgree) {
  using enum DistanceCorrection;
  const Window ring = Window::torus(unit_square);
  const Values asked{0.0, 0.01, 0.03, 0.05, 0.1, 0.3};
  for (const std::size_t count : {1U, 2U, 200U}) {
    const Points points = random_points(ring, count, 1);
    const Values g = nearest_neighbour_function(points, ring, asked, {none});
    EXPECT_EQ(nearest_neighbour_function(points, ring, asked, {border}), g);
    const Values survival = nearest_neighbour_function(points, ring, asked, {kaplan_meier});
    for (std::size_t k = 0; k < asked.size(); ++k)
      EXPECT_NEAR(survival[k], g[k], distribution_rounding);
  }
}

TEST(DistanceFunctionsOracle, BorderAndNoneAreThoseOfTheirDefinition) {
  using enum DistanceCorrection;
  const Values asked{0.01, 0.05, 0.1, 0.15};
  for (const auto& [name, window, points] : assorted_patterns()) {
    const Values measured = nearest_distances(points, window);
    for (const DistanceCorrection correction : {none, border}) {
      const Values g = nearest_neighbour_function(points, window, asked, {correction});
      for (std::size_t k = 0; k < asked.size(); ++k) {
        double all = 0.0, near = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          if (correction == border && distance_to_edge(window, points[i]) < asked[k]) continue;
          all += 1.0;
          near += measured[i] <= asked[k];
        }
        if (all > 0.0)
          EXPECT_EQ(g[k], near / all) << name;
        else
          EXPECT_TRUE(std::isnan(g[k])) << name;
      }
    }
  }
}

/// Probability that one of `others` uniform points lies within r of a place that far inside.
double disc_probability(double r, const Window& window, double others) {
  return 1.0 - std::pow(1.0 - std::numbers::pi * r * r / window.area(), others);
}

struct Means {
  std::vector<Sample> g, f, j;
};

constexpr std::size_t point_count = 200;

Means means_of(const Window& window, const Values& asked, DistanceCorrection correction) {
  Means means;
  means.g.resize(asked.size()), means.f = means.j = means.g;
  const auto add = [](std::vector<Sample>& samples, const Values& values) {
    for (std::size_t k = 0; k < values.size(); ++k) samples[k].add(values[k]);
  };
  for (std::uint64_t run = 0; run < 300; ++run) {
    const Points points = random_pattern(window, point_count, 81, run);
    const DistanceFunctionOptions options{correction, 40};
    add(means.g, nearest_neighbour_function(points, window, asked, options));
    add(means.f, empty_space_function(points, window, asked, options));
    add(means.j, j_function(points, window, asked, options));
  }
  return means;
}

const Values asked_of_random{0.01, 0.02, 0.03, 0.05, 0.07};

TEST(DistanceFunctionsLaw, OfRandomPatternsAreTheExponentialOnes) {
  using enum DistanceCorrection;
  for (const Window& window : {Window::rectangle(unit_square), Window::torus(unit_square)})
    for (const DistanceCorrection correction : {border, kaplan_meier}) {
      const Means means = means_of(window, asked_of_random, correction);
      for (std::size_t k = 0; k < asked_of_random.size(); ++k) {
        const double r = asked_of_random[k];
        const double g = disc_probability(r, window, point_count - 1.0);
        // The textbook form differs by the fixed number of points only.
        EXPECT_NEAR(g, 1.0 - std::exp(-std::numbers::pi * r * r * point_count), 0.01);
        EXPECT_LT(std::abs(means.g[k].errors_above(g)), chance) << k;
        EXPECT_LT(std::abs(means.f[k].errors_above(disc_probability(r, window, point_count))),
                  chance)
            << k;
        EXPECT_LT(std::abs(means.j[k].errors_above(1.0)), chance) << k;
      }
    }
}

TEST(DistanceFunctionsLaw, HoldInAPolygon) {
  using enum DistanceCorrection;
  const Means means = means_of(l_shape(), asked_of_random, kaplan_meier);
  for (std::size_t k = 0; k < asked_of_random.size(); ++k) {
    EXPECT_LT(std::abs(means.g[k].errors_above(
                  disc_probability(asked_of_random[k], l_shape(), point_count - 1.0))),
              chance);
    EXPECT_LT(std::abs(means.f[k].errors_above(
                  disc_probability(asked_of_random[k], l_shape(), point_count))),
              chance);
  }
}

// The laws above must be able to fail.
TEST(DistanceFunctionsLaw, UncorrectedAreFarBelow) {
  using enum DistanceCorrection;
  const Window plot = Window::rectangle(unit_square);
  const Means means = means_of(plot, asked_of_random, none);
  EXPECT_LT(means.g[3].errors_above(disc_probability(0.05, plot, point_count - 1.0)), -chance);
  EXPECT_LT(means.f[3].errors_above(disc_probability(0.05, plot, point_count)), -chance);
}

TEST(DistanceFunctions, OfALatticeStepAtItsSpacing) {
  using enum DistanceCorrection;
  const Window ring = Window::torus(lattice_box(8, 8));
  const Points lattice = square_lattice(8, 8);
  const Values asked{0.25, 0.5, std::nextafter(1.0, 0.0), 1.0};
  EXPECT_EQ(nearest_neighbour_function(lattice, ring, asked, {none}), (Values{0.0, 0.0, 0.0, 1.0}));
  // Up to half the spacing the discs do not meet: their share of the ground, up to the few places
  // of 64 x 64 per lattice cell by which counts in a circle miss its area.
  constexpr double counting = 5e-3;
  const Values f = empty_space_function(lattice, ring, asked, {none, 512});
  EXPECT_NEAR(f[0], std::numbers::pi / 16.0, counting);
  EXPECT_NEAR(f[1], std::numbers::pi / 4.0, counting);
  EXPECT_EQ(f[2], 1.0);
  const Values j = j_function(lattice, ring, asked, {none, 512});
  EXPECT_GT(j[0], 1.0);
  EXPECT_TRUE(std::isnan(j[3]));
}

TEST(DistanceFunctions, TellClustersByJ) {
  const Window plot = Window::rectangle(unit_square);
  const Points clusters = clustered_points(plot, 200, 0.05, 1);
  EXPECT_LT(j_function(clusters, plot, Values{0.02})[0], 0.5);
}

TEST(DistanceFunctions, OfTooFewOrEqualPointsAreDefined) {
  using enum DistanceCorrection;
  const Window plot = Window::rectangle(unit_square);
  const Points single{{0.5, 0.5}}, equal(9, Point2{0.5, 0.5});
  for (const DistanceCorrection correction : all_distance_corrections) {
    EXPECT_TRUE(std::isnan(nearest_neighbour_function({}, plot, Values{0.1}, {correction})[0]));
    EXPECT_EQ(empty_space_function({}, plot, Values{0.1}, {correction})[0], 0.0);
    EXPECT_TRUE(std::isnan(j_function({}, plot, Values{0.1}, {correction})[0]));
    EXPECT_EQ(nearest_neighbour_function(single, plot, Values{0.1}, {correction})[0], 0.0);
    EXPECT_EQ(nearest_neighbour_function(equal, plot, Values{0.0}, {correction})[0], 1.0);
  }
  const Points corners = plot.corners();  // on the border nothing is known but distance 0
  EXPECT_TRUE(std::isnan(nearest_neighbour_function(corners, plot, Values{0.1}, {border})[0]));
  EXPECT_EQ(nearest_neighbour_function(corners, plot, Values{1.0}, {kaplan_meier})[0], 0.0);
  EXPECT_EQ(nearest_neighbour_function(corners, plot, Values{1.0}, {none})[0], 1.0);
}

TEST(TestGrid, CoversTheWindowEvenly) {
  EXPECT_EQ(test_grid(Window::rectangle(unit_square), 2),
            (Points{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}));
  EXPECT_EQ(test_grid(l_shape(), 40).size(), 1200U);  // three quarters
}

TEST(DistanceFunctionsLaw, ThreadsDoNotMatter) {
  using enum DistanceCorrection;
  const Points points = random_points(l_shape(), 3000, 4);
  const DistanceFunctionOptions one{}, four{kaplan_meier, 128, 4};
  const Values asked{0.005, 0.01, 0.02};
  const Values j = j_function(points, l_shape(), asked, one);
  EXPECT_NEAR(j[1], 1.0, 0.2);
  EXPECT_EQ(j_function(points, l_shape(), asked, four), j);
}

TEST(DistanceFunctions, RefuseWhatHasNoMeaning) {
  using enum DistanceCorrection;
  const Window plot = Window::rectangle(unit_square);
  EXPECT_THROW(nearest_neighbour_function({}, plot, Values{0.2, 0.1}), ContractViolation);
  EXPECT_THROW(nearest_neighbour_function({}, plot, Values{infinity}), ContractViolation);
  EXPECT_THROW(empty_space_function({}, plot, Values{0.1}, {none, 0}), ContractViolation);
  EXPECT_THROW(distance_distribution(Values{1.0}, Values{}, Values{0.1}, none), ContractViolation);
}

}  // namespace
}  // namespace phytobench
