// SPDX-License-Identifier: MIT
#include "core/population/reproduction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using testing_populations::one_species;

/// Mothers of 0.3 m that shed 4 seeds each a step.
PopulationParameters mothers(std::int64_t count = 1000) {
  PopulationParameters parameters = one_species(count);
  parameters.species[0].start_radius_low = parameters.species[0].start_radius_high = 0.3;
  parameters.species[0].reproduction = {.threshold = 0.1, .seeds_per_metre = 20.0};
  return parameters;
}

TEST(Reproduction, SeedsArePoissonWithTheExpectedMean) {
  const PopulationParameters parameters = mothers();
  PopulationState state = sow(parameters);
  reproduce(state, parameters);
  EXPECT_NEAR(static_cast<double>(state.stand.size() - 1000), 4000, 4 * std::sqrt(4000.0));
  EXPECT_EQ(state.stand.stem_radius.back(), parameters.species[0].reproduction.seedling_radius);
}

TEST(Reproduction, SmallPlantsBearNothing) {
  PopulationParameters parameters = mothers();
  parameters.species[0].reproduction.threshold = 0.3;
  PopulationState state = sow(parameters);
  reproduce(state, parameters);
  EXPECT_EQ(state.stand.size(), 1000u);
}

TEST(Reproduction, SeedsFallAsFarAsTheLawSays) {
  PopulationParameters parameters = mothers(1);
  parameters.species[0].reproduction.seeds_per_metre = 50'000.0;
  parameters.species[0].reproduction.dispersal_distance = 2.0;
  PopulationState state = sow(parameters);
  const Point2 mother = state.stand.place(0);
  reproduce(state, parameters);
  double sum = 0.0;
  for (std::size_t i = 1; i < state.stand.size(); ++i) {
    Point2 d = state.stand.place(i) - mother;
    d.x -= 60.0 * std::round(d.x / 60.0);
    d.y -= 60.0 * std::round(d.y / 60.0);
    sum += norm(d);
  }
  const double count = static_cast<double>(state.stand.size() - 1);
  EXPECT_NEAR(sum / count, 2.0, 4 * 2.0 / std::sqrt(count));
}

TEST(Reproduction, FatesOfSeedsHaveTheirShares) {
  PopulationParameters parameters = mothers(5000);
  ReproductionParameters& seeds = parameters.species[0].reproduction;
  seeds.seed_mortality = 0.2;
  seeds.dormant_share = 0.25;
  seeds.establishment = 0.5;
  PopulationState state = sow(parameters);
  reproduce(state, parameters);
  const double shed = 20'000;
  EXPECT_NEAR(static_cast<double>(state.seeds.size()), shed * 0.8 * 0.25, 4 * 70);
  EXPECT_NEAR(static_cast<double>(state.stand.size() - 5000), shed * 0.8 * 0.75 * 0.5, 4 * 90);
}

TEST(Reproduction, RestingSeedsWakeAndDieGeometrically) {
  PopulationParameters parameters = mothers(1);
  parameters.species[0].reproduction = {.seed_mortality = 0.1, .germination_rate = 0.3};
  PopulationState state = sow(parameters);
  state.seeds.assign(100'000, {{0.0, 10.0}, 0});
  for (int i = 0; i < 3; ++i) {
    reproduce(state, parameters);
    ++state.step;
  }
  EXPECT_NEAR(static_cast<double>(state.seeds.size()), 100'000 * std::pow(0.9 * 0.7, 3), 4 * 160);
}

TEST(Reproduction, NothingTakesRootInABadYearButRestingSeedsLast) {
  PopulationParameters parameters = mothers();
  parameters.species[0].reproduction.dormant_share = 0.5;
  parameters.bad_year_share = 1.0;
  PopulationState state = sow(parameters);
  reproduce(state, parameters);
  EXPECT_EQ(state.stand.size(), 1000u);
  EXPECT_GT(state.seeds.size(), 1500u);
}

TEST(Reproduction, BadYearsHaveTheirFrequency) {
  PopulationParameters parameters = mothers();
  parameters.bad_year_share = 0.3;
  int bad = 0;
  for (std::int32_t step = 0; step < 10'000; ++step) bad += is_bad_year(parameters, step);
  EXPECT_NEAR(bad, 3000, 4 * std::sqrt(10'000 * 0.21));
}

TEST(Reproduction, SeedsBeyondAnOpenBorderAreLost) {
  PopulationParameters parameters = mothers();
  parameters.is_torus = false;
  parameters.species[0].reproduction.dispersal_distance = 60.0;
  PopulationState state = sow(parameters);
  reproduce(state, parameters);
  EXPECT_LT(state.stand.size(), 1000u + 3000u);
  for (std::size_t i = 0; i < state.stand.size(); ++i)
    ASSERT_TRUE(parameters.ground.contains(state.stand.place(i)));
}

TEST(Reproduction, EndlessGrowthIsStopped) {
  PopulationParameters parameters = mothers(100);
  parameters.most_plants = 200;
  PopulationState state = sow(parameters);
  EXPECT_THROW(reproduce(state, parameters), InputError);
}

}  // namespace
}  // namespace phytobench
