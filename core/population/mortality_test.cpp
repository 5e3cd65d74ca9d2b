// SPDX-License-Identifier: MIT
#include "core/population/mortality.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using testing_populations::one_species;

/// One plant that has grown by these amounts in its last steps, the last one in step `step`.
PopulationState grown(const PopulationParameters& parameters, std::vector<double> growths,
                      std::int32_t step) {
  PopulationState state;
  state.recent_growth.resize(static_cast<std::size_t>(parameters.mortality.window));
  state.born.assign(1, 0);
  state.died.assign(1, 0);
  add_plant(state, {0, 10}, 0.1, 0);
  state.step = step - static_cast<std::int32_t>(growths.size());
  for (const double growth : growths) {
    ++state.step;
    state.recent_growth[static_cast<std::size_t>(state.step) % state.recent_growth.size()][0] =
        static_cast<float>(growth);
    state.stand.stem_radius[0] += growth;
    ++state.stand.age[0];
  }
  return state;
}

PopulationParameters with(MortalityRule rule, double threshold, std::int32_t window = 4) {
  PopulationParameters parameters = one_species(0);
  parameters.mortality = {.rule = rule, .window = window, .threshold = threshold};
  return parameters;
}

TEST(Mortality, MeansRunOverTheLastStepsOnly) {
  const PopulationParameters parameters = with(MortalityRule::none, 0.0);
  const PopulationState state = grown(parameters, {0.1, 0.01, 0.02, 0.03, 0.04}, 22);
  EXPECT_NEAR(mean_recent_growth(state, 0), 0.025, 1e-9);
  // Radii after each of the last four steps: 0.21, 0.23, 0.26, 0.30.
  EXPECT_NEAR(mean_recent_radius(state, 0), 0.25, 1e-8);
}

TEST(Mortality, TheMeanOfAYoungPlantIsOverItsLife) {
  const PopulationParameters parameters = with(MortalityRule::none, 0.0);
  EXPECT_NEAR(mean_recent_growth(grown(parameters, {0.01, 0.03}, 9), 0), 0.02, 1e-9);
  EXPECT_TRUE(std::isnan(mean_recent_growth(grown(parameters, {}, 9), 0)));
}

TEST(Mortality, StarvesBelowTheThresholdOnceTheWindowIsFull) {
  for (const double threshold : {0.0099, 0.0101}) {
    const PopulationParameters parameters = with(MortalityRule::mean_growth, threshold);
    EXPECT_EQ(dies(grown(parameters, {0.01, 0.01, 0.01, 0.01}, 9), parameters, 0),
              threshold > 0.01);
    EXPECT_FALSE(dies(grown(parameters, {0.0, 0.0, 0.0}, 9), parameters, 0));
  }
}

TEST(Mortality, RelativeThresholdsScaleWithThePlant) {
  // 0.14 after four steps of 0.01.
  for (const double threshold : {0.0713, 0.0715}) {
    const PopulationParameters parameters = with(MortalityRule::mean_relative_growth, threshold);
    EXPECT_EQ(dies(grown(parameters, {0.01, 0.01, 0.01, 0.01}, 9), parameters, 0),
              threshold > 0.01 / 0.14);
  }
}

TEST(Mortality, GrownUpPlantsDoNotStarve) {
  const PopulationParameters parameters = with(MortalityRule::mean_growth, 0.1);
  EXPECT_TRUE(dies(grown(parameters, {0.08, 0.08, 0.08, 0.08}, 9), parameters, 0));
  EXPECT_FALSE(dies(grown(parameters, {0.095, 0.095, 0.095, 0.095}, 9), parameters, 0));
}

TEST(Mortality, ThePrintedRuleKillsSmallPlantsHoweverTheyThrive) {
  const PopulationParameters parameters = with(MortalityRule::mean_size, 0.5);
  EXPECT_TRUE(dies(grown(parameters, {0.05, 0.05, 0.05, 0.05}, 9), parameters, 0));
}

TEST(Mortality, AgeAndIllnessKill) {
  PopulationParameters parameters = with(MortalityRule::none, 0.0);
  parameters.species[0].largest_age = 3;
  EXPECT_FALSE(dies(grown(parameters, {0.1, 0.1}, 9), parameters, 0));
  EXPECT_TRUE(dies(grown(parameters, {0.1, 0.1, 0.1}, 9), parameters, 0));
  parameters.species[0].largest_age = 100;
  parameters.illness = {.duration = 5, .is_deadly = true};
  PopulationState state = grown(parameters, {0.1, 0.1}, 9);
  state.stand.ill_since[0] = 5;
  EXPECT_TRUE(dies(state, parameters, 0));
  state.stand.ill_since[0] = 6;
  EXPECT_FALSE(dies(state, parameters, 0));
}

}  // namespace
}  // namespace phytobench
