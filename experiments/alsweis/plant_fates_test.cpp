// SPDX-License-Identifier: MIT
#include "experiments/alsweis/plant_fates.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "experiments/alsweis/ecosystem.hpp"

namespace phytobench::experiments::alsweis {
namespace {

TEST(PlantFates, FollowPlantsByTheirIdsThroughDeathAndReordering) {
  PopulationParameters parameters = plot_of(20.0, 0.001, 1);
  parameters.species = {species_of(shrub, 40)};
  parameters.events = {{.kind = EventKind::removal, .step = 1, .plants = {3, 17}}};
  Population population = population_of(parameters);
  Fates fates = fates_at_start(population.stand());
  ASSERT_EQ(fates.size(), 40u);
  for (int t = 0; t < 10; ++t) population.step();
  update_fates(population.stand(), fates);
  EXPECT_EQ(fates.radius[3], 0.0);
  EXPECT_EQ(fates.radius[17], 0.0);
  EXPECT_EQ(std::count(fates.radius.begin(), fates.radius.end(), 0.0),
            static_cast<std::ptrdiff_t>(40 - population.stand().size()));
  const Stand& stand = population.stand();
  for (std::size_t i = 0; i < stand.size(); ++i) {
    EXPECT_EQ(fates.place[stand.id[i]], stand.place(i));
    EXPECT_EQ(fates.radius[stand.id[i]], stand.stem_radius[i]);
    EXPECT_LE(fates.start_radius[stand.id[i]], stand.stem_radius[i]);
  }
}

TEST(PlantFates, APlantThatWasNotThereIsABug) {
  PopulationParameters parameters = plot_of(20.0, 0.001, 1);
  parameters.species = {species_of(shrub, 2)};
  Population population = population_of(parameters);
  Fates fates = fates_at_start(population.stand());
  PopulationState state = population.state();
  add_plant(state, {1.0, 1.0}, 0.01, 0);
  EXPECT_THROW(update_fates(state.stand, fates), ContractViolation);
}

TEST(PlantFates, ATallyCountsTheDeadAndMeasuresTheLiving) {
  Tally tally, more;
  tally.add(1.0, 2.0);
  tally.add(1.0, 0.0);
  more.add(2.0, 8.0);
  more.add(1.0, 0.0);
  tally += more;
  EXPECT_EQ(tally.plants, 4);
  EXPECT_EQ(tally.survivors, 2);
  EXPECT_EQ(tally.survival(), 0.5);
  EXPECT_EQ(tally.mean_radius(), 5.0);
  EXPECT_EQ(tally.mean_growth(), 3.0);
}

TEST(PlantFates, StandardErrorsAreThoseOfTwoProportions) {
  Tally low, high;
  for (int i = 0; i < 100; ++i) {
    low.add(1.0, i < 40 ? 1.0 : 0.0);
    high.add(1.0, i < 60 ? 1.0 : 0.0);
  }
  EXPECT_NEAR(standard_errors_between(low, high), 0.2 / std::sqrt(0.25 * 0.02), 1e-12);
  EXPECT_NEAR(standard_errors_between(high, low), -standard_errors_between(low, high), 1e-12);
}

TEST(PlantFates, NoMeanIsRecordedWhereThereIsNone) {
  ExperimentContext context("alsweis/test", Tier::smoke, 1, 1);
  Tally dead;
  dead.add(1.0, 0.0);
  record_tally(context, "nobody", Tally{});
  record_tally(context, "dead", dead);
  EXPECT_EQ(context.records().size(), 2u + 3u);
}

TEST(Ecosystem, TheShareOfWinsIsThatOfAllPairs) {
  ExperimentContext context("alsweis/test", Tier::smoke, 1, 1);
  record_order(context, "order", std::vector{2.0, 1.0, 5.0, 3.0}, std::vector{1.0, 1.0, 4.0, 4.0});
  EXPECT_EQ(std::get<double>(context.records().back().value), 0.5);
  EXPECT_EQ(context.records().back().measurement, "alsweis/test/order/share_of_wins");
}

TEST(Ecosystem, ZonesGrowWithTheRootOfTheStem) {
  EXPECT_EQ(zone_radius_of(12.0, 0.25), 6.0);
  const Species species = species_of(tree, 3);
  EXPECT_EQ(species.roots.exponent, 0.5);
  EXPECT_EQ(species.roots.rich_factor, 12.0);
  EXPECT_EQ(species.crown.poor_factor, 10.0);
}

}  // namespace
}  // namespace phytobench::experiments::alsweis
