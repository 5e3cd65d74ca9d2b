// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/literal_losses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/competition/step_race.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// Plants that lose something under the rule, and what.
struct Assessed {
  explicit Assessed(std::string_view rule, std::int64_t plants = 150)
      : parameters(stepping_population(plants, 5.0, 3)) {
    parameters.rule = rule;
    Population population(parameters, sow(parameters), overlap_engine_named("layered_grid"));
    losses = population.losses();
    stand = population.stand();
  }
  std::string objection() const { return objection_to_rule_losses(losses, parameters, stand); }

  PopulationParameters parameters;
  Stand stand;
  std::vector<double> losses;
};

std::vector<std::string_view> rules_with_neighbours() {
  std::vector<std::string_view> names;
  for (const CompetitionRuleDescriptor* rule : all_competition_rules())
    if (rule->built() && (rule->uses_below || rule->uses_above)) names.push_back(rule->name);
  return names;
}

TEST(LiteralLosses, AcceptEveryRuleThatIsRightAndSeeOneWrongPlant) {
  for (const std::string_view rule : rules_with_neighbours()) {
    Assessed assessed(rule);
    EXPECT_EQ(assessed.objection(), "") << rule;
    const double right = assessed.losses[17];
    for (const double wrong :
         {right + 1e-8, right - 1e-8, std::numeric_limits<double>::quiet_NaN()}) {
      assessed.losses[17] = wrong;
      EXPECT_THAT(assessed.objection(), HasSubstr("plant 17")) << rule;
    }
  }
}

TEST(LiteralLosses, SeeTheLossesOfAnotherRule) {
  for (const std::string_view rule : rules_with_neighbours())
    for (const std::string_view other : rules_with_neighbours()) {
      Assessed assessed(rule, 40);
      const Assessed by_other(other, 40);
      double off = 0.0;
      for (std::size_t i = 0; i < assessed.losses.size(); ++i)
        off = std::max(off, std::abs(assessed.losses[i] - by_other.losses[i]));
      assessed.losses = by_other.losses;
      EXPECT_EQ(assessed.objection() == "", off < 1e-9) << rule << ", " << other;
    }
}

/// The rules read tables and numbers that the default leaves at 1 or empty.
TEST(LiteralLosses, ReadAllParameters) {
  for (const std::string_view rule : rules_with_neighbours()) {
    PopulationParameters parameters = stepping_population(150, 5.0, 4);
    parameters.rule = rule;
    using enum Influence;
    parameters.competition.above_share = 0.3;
    parameters.competition.asymmetry_exponent = 1.7;
    parameters.competition.light_constant = 1.3;
    parameters.competition.field_at_rim = 0.4;
    parameters.competition.influence_above = {harms, none, harms, helps};
    parameters.competition.influence_below = {none, helps, harms, harms};
    Population population(parameters, sow(parameters), overlap_engine_named("layered_grid"));
    const std::vector<double> losses = population.losses();
    EXPECT_EQ(objection_to_rule_losses(losses, parameters, population.stand()), "") << rule;
  }
}

TEST(LiteralLosses, SeeWhatIsMissing) {
  Assessed assessed("mixture");
  assessed.losses.pop_back();
  EXPECT_THAT(assessed.objection(), HasSubstr("149 losses of 150 plants"));
}

TEST(LiteralLosses, KnowWhatTheyDoNotKnow) {
  Assessed assessed("mixture");
  assessed.parameters.rule = "brand_new";
  EXPECT_THAT(assessed.objection(), HasSubstr("no oracle knows the rule 'brand_new'"));
}

}  // namespace
}  // namespace phytobench
