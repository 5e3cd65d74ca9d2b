// SPDX-License-Identifier: MIT
#include "core/population/population_events.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using testing_populations::one_species;
using testing_populations::population_of;

PopulationParameters with_event(const PopulationEvent& event, std::int64_t count = 1000) {
  PopulationParameters parameters = one_species(count);
  parameters.ground = {{0, 0}, {1000, 1000}};
  parameters.species.push_back(parameters.species[0]);
  parameters.species[1].name = "other";
  parameters.events = {event};
  return parameters;
}

TEST(PopulationEvents, AShareStrikesThatManyOfItsSpecies) {
  const PopulationParameters parameters = with_event({.step = 0, .species = 1, .share = 0.3}, 4000);
  const PopulationState state = sow(parameters);
  const std::vector<std::size_t> struck = plants_selected(state, parameters, 0);
  for (const std::size_t i : struck) ASSERT_EQ(state.stand.species[i], 1);
  EXPECT_NEAR(static_cast<double>(struck.size()), 1200, 4 * std::sqrt(4000 * 0.3 * 0.7));
}

TEST(PopulationEvents, WhoIsStruckDoesNotDependOnTheOrderOfPlants) {
  const PopulationParameters parameters = with_event({.step = 0, .share = 0.3});
  PopulationState state = sow(parameters);
  const auto ids = [&] {
    std::vector<PlantId> struck;
    for (const std::size_t i : plants_selected(state, parameters, 0))
      struck.push_back(state.stand.id[i]);
    std::sort(struck.begin(), struck.end());
    return struck;
  };
  const std::vector<PlantId> before = ids();
  order_by_place(state, parameters.ground);
  EXPECT_EQ(ids(), before);
}

TEST(PopulationEvents, TheLargestAreTakenOut) {
  const PopulationParameters parameters =
      with_event({.kind = EventKind::removal, .step = 0, .largest = 3});
  PopulationState state = sow(parameters);
  std::vector<double> radii = state.stand.stem_radius;
  apply_events(state, parameters);
  EXPECT_EQ(state.stand.size(), radii.size() - 3);
  std::nth_element(radii.begin(), radii.end() - 4, radii.end());
  EXPECT_EQ(*std::max_element(state.stand.stem_radius.begin(), state.stand.stem_radius.end()),
            *(radii.end() - 4));
  EXPECT_EQ(state.died[0] + state.died[1], 3u);
}

TEST(PopulationEvents, NamedPlantsFallIllAtTheirStep) {
  const PopulationParameters parameters = with_event({.step = 3, .plants = {7, 2, 5'000}}, 10);
  Population population = population_of(parameters);
  for (int i = 0; i < 3; ++i) population.step();
  EXPECT_EQ(
      std::count(population.stand().ill_since.begin(), population.stand().ill_since.end(), healthy),
      20);
  population.step();
  for (std::size_t i = 0; i < population.stand().size(); ++i) {
    const PlantId id = population.stand().id[i];
    EXPECT_EQ(population.stand().ill_since[i], id == 7 || id == 2 ? 3 : healthy);
  }
}

TEST(PopulationEvents, ASickRivalSetsItsNeighbourFree) {
  PopulationParameters parameters = one_species(0);
  parameters.rule = "disease";
  parameters.competition.above_share = 0.0;
  const std::vector<StartPlant> plants = {{{10, 20}, 0.05, 0}, {{18, 20}, 0.05, 0}};
  const auto radius_of_first = [&] {
    Population population = population_of(parameters, 1, plants);
    for (int i = 0; i < 60; ++i) population.step();
    const std::size_t first = order_of_ids(population.stand())[0];
    return population.stand().stem_radius[first];
  };
  const double with_healthy = radius_of_first();
  parameters.events = {{.step = 0, .plants = {1}}};
  EXPECT_GT(radius_of_first(), with_healthy + 0.02);
}

}  // namespace
}  // namespace phytobench
