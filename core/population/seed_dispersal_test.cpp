// SPDX-License-Identifier: MIT
#include "core/population/seed_dispersal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench {
namespace {

using std::numbers::pi;
constexpr double least_p = 1e-3;  // seeds are fixed: no test fails by chance later on
constexpr int draws = 100'000;

std::vector<Point2> seeds_of(const SeedDispersal& dispersal, std::uint64_t stream) {
  CounterStream numbers(3, stream);
  std::vector<Point2> seeds;
  for (int i = 0; i < draws; ++i) seeds.push_back(dispersal.draw(numbers));
  return seeds;
}

/// Simpson's rule.
template <class Function>
double integral(double low, double high, const Function& f) {
  constexpr int intervals = 20'000;
  const double h = (high - low) / intervals;
  double sum = f(low) + f(high);
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 0 ? 2.0 : 4.0) * f(low + i * h);
  return sum * h / 3.0;
}

TEST(SeedDispersalLaw, DrawsHaveTheDistanceDistribution) {
  for (const DispersalLaw law : all_dispersal_laws)
    for (const double scale : {0.3, 5.0}) {
      const SeedDispersal dispersal{law, scale};
      std::vector<double> places;
      for (const Point2& seed : seeds_of(dispersal, 1))
        places.push_back(dispersal.distance_distribution(norm(seed)));
      EXPECT_GT(kolmogorov_uniformity_p_value(places), least_p) << name_of(law);
    }
}

// The test above must see laws that are not the one that was drawn.
TEST(SeedDispersalLaw, DrawsOfOneLawAreNotThoseOfAnother) {
  for (const DispersalLaw drawn : all_dispersal_laws)
    for (const DispersalLaw other : all_dispersal_laws) {
      if (drawn == other) continue;
      // With the scale at which the means agree.
      const SeedDispersal wrong{other, SeedDispersal{drawn, 1.0}.mean_distance() /
                                           SeedDispersal{other, 1.0}.mean_distance()};
      std::vector<double> places;
      for (const Point2& seed : seeds_of({drawn, 1.0}, 2))
        places.push_back(wrong.distance_distribution(norm(seed)));
      EXPECT_LT(kolmogorov_uniformity_p_value(places), 1e-9);
    }
}

TEST(SeedDispersalLaw, AllDirectionsAreAlike) {
  for (const DispersalLaw law : all_dispersal_laws) {
    std::vector<double> turns, turns_of_far;
    const SeedDispersal dispersal{law, 2.0};
    for (const Point2& seed : seeds_of(dispersal, 3)) {
      turns.push_back((std::atan2(seed.y, seed.x) + pi) / (2.0 * pi));
      if (norm(seed) > dispersal.median_distance()) turns_of_far.push_back(turns.back());
    }
    EXPECT_GT(kolmogorov_uniformity_p_value(turns), least_p) << name_of(law);
    EXPECT_GT(kolmogorov_uniformity_p_value(turns_of_far), least_p) << name_of(law);
  }
}

TEST(SeedDispersalLaw, MeanOfDrawsIsTheMean) {
  for (const DispersalLaw law : all_dispersal_laws) {
    const SeedDispersal dispersal{law, 5.0};
    RunningMoments distance;
    for (const Point2& seed : seeds_of(dispersal, 4)) distance.add(norm(seed));
    EXPECT_NEAR(distance.mean(), dispersal.mean_distance(), 4.0 * distance.standard_error());
  }
}

TEST(SeedDispersalLaw, DensitiesIntegrateToTheDistribution) {
  for (const DispersalLaw law : all_dispersal_laws) {
    const SeedDispersal dispersal{law, 1.5};
    const auto density = [&](double r) { return dispersal.distance_density(r); };
    for (const double r : {0.1, 1.0, 4.0, 60.0})
      EXPECT_NEAR(integral(0.0, r, density), dispersal.distance_distribution(r), 1e-10);
    EXPECT_NEAR(integral(0.0, 90.0, [&](double r) { return r * density(r); }),
                dispersal.mean_distance(), 1e-9);
    for (const double r : {0.2, 1.0, 7.0})
      EXPECT_NEAR(dispersal.plane_density(r) * 2.0 * pi * r, density(r), 1e-15);
  }
}

TEST(SeedDispersal, QuantilesInvertTheDistribution) {
  for (const DispersalLaw law : all_dispersal_laws) {
    const SeedDispersal dispersal{law, 7.0};
    EXPECT_EQ(dispersal.distance_quantile(0.0), 0.0);
    for (const double share : {1e-6, 0.1, 0.5, 0.95, 0.999999})
      EXPECT_NEAR(dispersal.distance_distribution(dispersal.distance_quantile(share)), share,
                  1e-14);
    EXPECT_THROW(dispersal.distance_quantile(1.0), ContractViolation);
  }
}

TEST(SeedDispersal, MeanAndMedianAreThoseOfTheClosedForms) {
  struct Case {
    DispersalLaw law;
    double mean, median, most;
  };
  for (const Case& c : {Case{DispersalLaw::radial_exponential, 1.0, 0.693147, 2.995732},
                        Case{DispersalLaw::planar_exponential, 2.0, 1.678347, 4.743865},
                        Case{DispersalLaw::gaussian, 1.253314, 1.177410, 2.447747}}) {
    const SeedDispersal dispersal{c.law, 1.0};
    EXPECT_NEAR(dispersal.mean_distance(), c.mean, 1e-6);
    EXPECT_NEAR(dispersal.median_distance(), c.median, 1e-6);
    EXPECT_NEAR(dispersal.distance_quantile(0.95), c.most, 1e-6);
    EXPECT_NEAR((SeedDispersal{c.law, 5.0}.median_distance()), 5.0 * c.median, 5e-6);
  }
}

TEST(SeedDispersal, NothingFallsNearerThanTheMother) {
  for (const DispersalLaw law : all_dispersal_laws) {
    EXPECT_EQ((SeedDispersal{law, 1.0}.distance_distribution(-1.0)), 0.0);
    EXPECT_EQ((SeedDispersal{law, 1.0}.distance_density(-1.0)), 0.0);
    EXPECT_EQ((SeedDispersal{law, 1.0}.distance_distribution(1e9)), 1.0);
  }
  EXPECT_TRUE(std::isinf(SeedDispersal{}.plane_density(0.0)));
}

TEST(DispersalLawNames, AreReadAndRefused) {
  for (const DispersalLaw law : all_dispersal_laws)
    EXPECT_EQ(dispersal_law_named(std::string(name_of(law))), law);
  try {
    dispersal_law_named("gausian");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "there is no dispersal law 'gausian'; use one of: radial-exponential, "
              "planar-exponential, gaussian; did you mean 'gaussian'?");
  }
}

}  // namespace
}  // namespace phytobench
