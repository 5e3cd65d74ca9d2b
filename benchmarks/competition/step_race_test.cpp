// SPDX-License-Identifier: MIT
#include "benchmarks/competition/step_race.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"

namespace phytobench {
namespace {

TEST(StepRace, TimesEveryRuleThatIsRight) {
  StepRaceRequest request{.plants = 600, .rounds = 3};
  for (const CompetitionRuleDescriptor* rule : all_competition_rules())
    if (rule->built()) request.contestants.push_back({.rule = rule, .threads = 2});
  for (const StepEntry& entry : race_steps(request)) {
    EXPECT_EQ(entry.objection, "") << entry.rule->name;
    EXPECT_EQ(entry.seconds.size(), 3u) << entry.rule->name;
    EXPECT_EQ(entry.pairs > 0, entry.rule->uses_below) << entry.rule->name;
  }
}

TEST(StepRace, ThePopulationHasThePairsAskedForAndStays) {
  for (const double wanted : {1.0, 5.0}) {
    PopulationParameters parameters = stepping_population(20'000, wanted, 3);
    parameters.rule = "symmetric";
    Population population(parameters, sow(parameters), overlap_engine_named("layered_grid"));
    population.step();
    EXPECT_NEAR(static_cast<double>(population.pairs_found()) / 20'000, wanted, 0.05 * wanted);
    for (int i = 0; i < 10; ++i) population.step();
    EXPECT_EQ(population.stand().size(), 20'000u);
  }
}

TEST(StepRace, WrongLossesAreSeen) {
  const std::vector<double> right = {0.0, 0.3, 2.0};
  EXPECT_EQ(objection_to_losses(right, right), "");
  EXPECT_THAT(objection_to_losses(std::vector{0.0, 0.3, 2.000001}, right),
              testing::HasSubstr("plant 2"));
  EXPECT_THAT(
      objection_to_losses(std::vector{0.0, std::numeric_limits<double>::quiet_NaN(), 2.0}, right),
      testing::HasSubstr("plant 1"));
  EXPECT_THAT(objection_to_losses(std::vector{0.0, 0.3}, right), testing::HasSubstr("2 losses"));
}

TEST(StepRace, StopsWhenAsked) {
  const StepRaceRequest request{.plants = 100,
                                .contestants = {{.rule = all_competition_rules()[1]}},
                                .is_interrupted = [] { return true; }};
  EXPECT_THROW(race_steps(request), Interrupted);
}

}  // namespace
}  // namespace phytobench
