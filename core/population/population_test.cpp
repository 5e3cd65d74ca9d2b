// SPDX-License-Identifier: MIT
#include "core/population/population.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/richards_growth.hpp"
#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using testing_populations::after;
using testing_populations::lively;
using testing_populations::one_species;
using testing_populations::population_of;
using testing_populations::same;

double mean_radius(const Population& population) {
  const std::vector<double>& radii = population.stand().stem_radius;
  return std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
}

TEST(PopulationLaw, SameBitsForAnyNumberOfThreads) {
  const Population one = after(lively(), 60, 1);
  ASSERT_GT(one.state().born[0], one.parameters().species[0].count);
  for (const int threads : {2, 3, 5})
    EXPECT_TRUE(same(after(lively(), 60, threads).state(), one.state()));
}

TEST(PopulationLaw, SameBitsWhenTakenUpAgainFromAnyStep) {
  const PopulationParameters parameters = lively(4);
  const Population whole = after(parameters, 40);
  for (const int middle : {1, 8, 17, 33}) {
    Population second(parameters, after(parameters, middle).state(),
                      overlap_engine_named("layered_grid"));
    while (second.state().step < 40) second.step();
    EXPECT_TRUE(same(second.state(), whole.state())) << middle;
  }
}

TEST(PopulationLaw, LookingAtLossesChangesNothing) {
  // Through reordering, events and deaths: a loss that was kept too long would show.
  Population watched = population_of(lively(5)), unwatched = population_of(lively(5));
  for (int i = 0; i < 40; ++i) {
    const std::vector<double> before = watched.losses();
    EXPECT_EQ(watched.losses(), before);
    watched.step();
    unwatched.step();
    ASSERT_TRUE(same(watched.state(), unwatched.state())) << i;
    ASSERT_EQ(watched.pairs_found(), unwatched.pairs_found());
  }
}

TEST(PopulationLaw, SeedsOfRandomNumbersMatter) {
  EXPECT_FALSE(same(after(lively(1), 10).state(), after(lively(2), 10).state()));
}

TEST(PopulationLaw, EveryPlantThatWasBornIsAliveOrDied) {
  Population population = population_of(lively(2));
  for (int i = 0; i < 120; ++i) {
    population.step();
    const PopulationState& state = population.state();
    std::vector<std::uint64_t> alive(2, 0);
    for (const SpeciesIndex species : state.stand.species) ++alive[species];
    for (const std::size_t s : {0u, 1u}) ASSERT_EQ(state.born[s] - state.died[s], alive[s]);
    ASSERT_EQ(state.born[0] + state.born[1], state.next_id);
    const std::set<PlantId> ids(state.stand.id.begin(), state.stand.id.end());
    ASSERT_EQ(ids.size(), state.stand.size());
  }
}

TEST(PopulationLaw, PlantsStayOnTheGroundAndBelowTheirLargestSize) {
  for (const bool torus : {true, false}) {
    PopulationParameters parameters = lively(3);
    parameters.is_torus = torus;
    const Population population = after(parameters, 80);
    const Stand& stand = population.stand();
    for (std::size_t i = 0; i < stand.size(); ++i) {
      ASSERT_TRUE(parameters.ground.contains(stand.place(i)));
      ASSERT_LE(stand.stem_radius[i], parameters.species[stand.species[i]].largest_radius);
      ASSERT_GT(stand.stem_radius[i], 0.0);
    }
  }
}

TEST(PopulationLaw, PlantsWithoutNeighboursGrowAsIfAlone) {
  PopulationParameters parameters = one_species(0);
  for (const char* rule : {"none", "mixture", "above_below"}) {
    parameters.rule = rule;
    const StartPlant plant{{10, 20}, 0.05, 0};
    Population population = population_of(parameters, 1, std::span(&plant, 1));
    double radius = 0.05;
    for (int i = 0; i < 100; ++i) {
      population.step();
      radius += 0.05 * (radius / 0.5) * (1 - radius / 0.5);
      ASSERT_DOUBLE_EQ(population.stand().stem_radius[0], radius) << rule;
    }
    EXPECT_EQ(population.stand().age[0], 100);
  }
}

TEST(PopulationLaw, SmallStepsApproachTheClosedFormAtFirstOrder) {
  // Steps of half the length: half the rate, twice as many of them.
  const double exact = richards_size({.rate = 0.1, .final_size = 0.5, .shape = 2.0}, 0.05, 30.0);
  double before = 0.0;
  for (const int finer : {1, 2, 4, 8, 16}) {
    PopulationParameters parameters = one_species(0);
    parameters.species[0].growth_rate = 0.05 / finer;
    const StartPlant plant{{10, 20}, 0.05, 0};
    Population population = population_of(parameters, 1, std::span(&plant, 1));
    for (int i = 0; i < 30 * finer; ++i) population.step();
    const double error = std::abs(population.stand().stem_radius[0] - exact);
    if (finer > 1) EXPECT_NEAR(before / error, 2.0, 0.15) << finer;
    before = error;
  }
}

TEST(PopulationLaw, CompetitionHoldsPlantsBack) {
  PopulationParameters parameters = one_species();
  parameters.rule = "none";
  const double alone = mean_radius(after(parameters, 60));
  for (const char* rule : {"symmetric", "asymmetric", "above_below", "exact_shares"}) {
    parameters.rule = rule;
    EXPECT_LT(mean_radius(after(parameters, 60)), 0.9 * alone) << rule;
  }
}

TEST(PopulationLaw, RichardsOfShapeTwoIsTheBasalLaw) {
  PopulationParameters parameters = one_species(20);
  const Population basal = after(parameters, 30);
  parameters.species[0].growth = GrowthLaw::richards;
  const Population richards = after(parameters, 30);
  for (std::size_t i = 0; i < basal.stand().size(); ++i)
    EXPECT_NEAR(richards.stand().stem_radius[i], basal.stand().stem_radius[i], 1e-12);
}

TEST(PopulationLaw, StrongHelpDoesNotCarryBeyondTheLargestSize) {
  PopulationParameters parameters = one_species(0);
  parameters.rule = "nurse";
  parameters.species[0].growth_rate = 0.5;  // of a plant of 0.5: the longest step allowed
  std::vector<StartPlant> plants;
  for (int i = 0; i < 20; ++i) plants.push_back({{10.0 + 0.1 * i, 20.0}, 0.2, 0});
  Population population = population_of(parameters, 1, plants);
  for (int i = 0; i < 10; ++i) {
    population.step();
    for (const double radius : population.stand().stem_radius) ASSERT_LE(radius, 0.5);
  }
}

TEST(PopulationLaw, CountsAndSizesHoldOverTenThousandSteps) {
  PopulationParameters parameters = one_species(30);
  parameters.ground = {{0, 0}, {40, 40}};
  parameters.species[0].largest_age = 80;
  parameters.species[0].reproduction = {.threshold = 0.15,
                                        .seeds_per_metre = 4.0,
                                        .dormant_share = 0.5,
                                        .germination_rate = 0.3,
                                        .seedling_radius = 0.03};
  parameters.species[0].reproduction.seed_mortality = 0.2;
  parameters.mortality = {.rule = MortalityRule::mean_relative_growth, .threshold = 0.004};
  parameters.bad_year_share = 0.1;
  Population population = population_of(parameters);
  for (int i = 0; i < 10'000; ++i) population.step();
  const PopulationState& state = population.state();
  ASSERT_EQ(state.born[0] - state.died[0], state.stand.size());
  EXPECT_GT(state.stand.size(), 10u);
  EXPECT_GT(state.died[0], 10'000u);
  for (const double radius : state.stand.stem_radius) EXPECT_TRUE(radius > 0.0 && radius <= 0.5);
  for (const std::int32_t age : state.stand.age) EXPECT_LT(age, 80);
}

TEST(Population, ZonesThatMeetThemselvesRoundTheTorusAreRefused) {
  PopulationParameters parameters = one_species(3);
  parameters.ground = {{0, 0}, {7, 7}};
  Population population = population_of(parameters);
  EXPECT_THROW(population.step(), InputError);
  parameters.is_torus = false;
  EXPECT_NO_THROW(population_of(parameters).step());
}

TEST(Population, UnknownRulesAreRefused) {
  PopulationParameters parameters = one_species();
  parameters.rule = "unheard-of";
  EXPECT_THROW(population_of(parameters), InputError);
}

TEST(Sow, PlacesAreUniformAndSizesInTheirRange) {
  const PopulationState state = sow(one_species(4000));
  double x = 0.0, y = 0.0;
  for (std::size_t i = 0; i < state.stand.size(); ++i) {
    x += state.stand.x[i] / 4000;
    y += state.stand.y[i] / 4000;
    ASSERT_GE(state.stand.stem_radius[i], 0.03);
    ASSERT_LE(state.stand.stem_radius[i], 0.07);
  }
  const double four_errors = 4 * 60 / std::sqrt(12.0 * 4000);
  EXPECT_NEAR(x, 20.0, four_errors);
  EXPECT_NEAR(y, 35.0, four_errors);
}

TEST(Sow, GivenPlantsComeFirstAndMustFit) {
  const PopulationParameters parameters = one_species(2);
  const std::vector<StartPlant> plants = {{{0, 10}, 0.4, 0}};
  const PopulationState state = sow(parameters, plants);
  EXPECT_EQ(state.stand.size(), 3u);
  EXPECT_EQ(state.stand.stem_radius[0], 0.4);
  for (const StartPlant& wrong : {StartPlant{{-11, 10}, 0.4, 0}, StartPlant{{0, 10}, 0.0, 0},
                                  StartPlant{{0, 10}, 0.6, 0}, StartPlant{{0, 10}, 0.4, 1}})
    EXPECT_THROW(sow(parameters, std::span(&wrong, 1)), InputError);
}

}  // namespace
}  // namespace phytobench
