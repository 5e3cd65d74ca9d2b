// SPDX-License-Identifier: MIT
// What must hold for every rule of competition_rules.def.
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/competition/test_stands.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing_stands::crowded_stand;
using testing_stands::losses;
using testing_stands::TestStand;
using testing_stands::two_species;

TEST(CompetitionRules, HaveUniqueNamesAndSayWhatTheyDo) {
  std::set<std::string_view> names;
  for (const CompetitionRuleDescriptor* rule : all_competition_rules()) {
    EXPECT_TRUE(names.insert(rule->name).second) << rule->name;
    EXPECT_TRUE(rule->summary.ends_with('.')) << rule->name;
    EXPECT_FALSE(rule->source.empty()) << rule->name;
  }
  EXPECT_GE(names.size(), 13u);
}

TEST(CompetitionRules, UnknownNamesAreRefusedWithTheClosest) {
  try {
    competition_rule_named("asymetric");
    FAIL() << "an unknown rule was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'asymmetric'"));
  }
}

class EveryRuleLaw : public testing::TestWithParam<const CompetitionRuleDescriptor*> {
 protected:
  std::string_view name() const { return GetParam()->name; }
};

INSTANTIATE_TEST_SUITE_P(Rules, EveryRuleLaw, testing::ValuesIn(all_competition_rules()),
                         [](const auto& rule) { return std::string(rule.param->name); });

TEST_P(EveryRuleLaw, SameBitsForAnyNumberOfThreads) {
  for (const bool torus : {false, true}) {
    const TestStand stand = crowded_stand(300, torus);
    const std::vector<double> one = losses(name(), two_species(), stand, 1, "layered_grid");
    for (const int threads : {2, 3, 7})
      EXPECT_EQ(losses(name(), two_species(), stand, threads, "layered_grid"), one) << threads;
  }
}

TEST_P(EveryRuleLaw, DoesNotDependOnTheOrderOfPlants) {
  for (const bool torus : {false, true}) {
    const TestStand stand = crowded_stand(200, torus);
    CounterStream stream(11, 0);
    const std::vector<std::size_t> order = random_order(stand.size(), stream);
    const std::vector<double> loss = losses(name(), two_species(), stand);
    const std::vector<double> permuted = losses(name(), two_species(), stand.permuted(order));
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_NEAR(permuted[i], loss[order[i]], 1e-11) << i;
  }
}

TEST_P(EveryRuleLaw, DoesNotDependOnTheOverlapEngine) {
  const TestStand stand = crowded_stand(200, true);
  const std::vector<double> loss = losses(name(), two_species(), stand, 1, "all_pairs");
  for (const std::string_view engine : {"sweep", "cell_grid", "layered_grid"}) {
    const std::vector<double> other = losses(name(), two_species(), stand, 1, engine);
    for (std::size_t i = 0; i < loss.size(); ++i) EXPECT_NEAR(other[i], loss[i], 1e-11) << engine;
  }
}

TEST_P(EveryRuleLaw, DoesNotDependOnTheUnitOfLength) {
  const TestStand stand = crowded_stand(100, false);
  TestStand scaled = stand;
  for (std::vector<double>* lengths :
       {&scaled.x, &scaled.y, &scaled.below, &scaled.above, &scaled.stem})
    for (double& length : *lengths) length *= 100.0;
  const std::vector<double> loss = losses(name(), two_species(), stand);
  const std::vector<double> in_cm = losses(name(), two_species(), scaled);
  for (std::size_t i = 0; i < loss.size(); ++i) EXPECT_NEAR(in_cm[i], loss[i], 1e-9) << i;
}

TEST_P(EveryRuleLaw, DoesNotDependOnWhereATorusBegins) {
  const TestStand stand = crowded_stand(150, true);
  TestStand moved = stand;
  const Rectangle box = *stand.ground.torus;
  for (double& x : moved.x) x = x + 7.0 > box.high.x ? x + 7.0 - box.width() : x + 7.0;
  const std::vector<double> loss = losses(name(), two_species(), stand);
  const std::vector<double> there = losses(name(), two_species(), moved);
  for (std::size_t i = 0; i < loss.size(); ++i) EXPECT_NEAR(there[i], loss[i], 1e-9) << i;
}

TEST_P(EveryRuleLaw, PairsAreCountedAlike) {
  const TestStand stand = crowded_stand(100, true);
  const auto pairs_of = [&](std::string_view rule) {
    PairSearch search(overlap_engine_named("all_pairs"), {});
    std::vector<double> loss(stand.size());
    competition_rule_named(rule)
        .create(two_species())
        ->assess(stand.plants(), stand.ground, search, loss);
    return search.pairs_found();
  };
  if (GetParam()->uses_above || !GetParam()->uses_below) return;
  EXPECT_EQ(pairs_of(name()), pairs_of("symmetric"));
}

TEST_P(EveryRuleLaw, APlantAloneLosesNothing) {
  TestStand stand;
  stand.add(0, 0, 2.0, 1.5, 1);
  stand.add(10, 0, 1.0, 1.0, 1);
  EXPECT_EQ(losses(name(), two_species(), stand), (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(losses(name(), two_species(), TestStand()), std::vector<double>());
}

TEST_P(EveryRuleLaw, FarPlantsDoNotMatter) {
  TestStand near;
  near.add(0, 0, 2.0, 1.5);
  near.add(2, 0.5, 1.5, 1.0, 1);
  TestStand with_others = near;
  with_others.add(30, 0, 3.0, 2.0);
  with_others.add(31, 1, 2.0, 2.0, 1);
  const std::vector<double> loss = losses(name(), two_species(), near);
  const std::vector<double> same = losses(name(), two_species(), with_others);
  EXPECT_EQ(loss[0], same[0]);
  EXPECT_EQ(loss[1], same[1]);
}

TEST_P(EveryRuleLaw, TwinsFareAlike) {
  CompetitionParameters parameters = two_species();
  TestStand stand;
  stand.add(0, 0, 2.0, 1.5);
  stand.add(1.2, 0.7, 2.0, 1.5);
  const std::vector<double> loss = losses(name(), parameters, stand);
  EXPECT_EQ(loss[0], loss[1]);
}

/// Where everyone harms everyone, what is lost is less than all, for a single neighbour.
TEST_P(EveryRuleLaw, OneNeighbourTakesNoMoreThanThereIs) {
  CompetitionParameters parameters;
  parameters.light_constant = 3.0;  // (5.3)'s; no more in the innermost ring than (5.4)
  CounterStream stream(3, 0);
  for (int i = 0; i < 200; ++i) {
    TestStand stand;
    stand.add(0, 0, 0.1 + stream.next_unit(), 0.1 + stream.next_unit());
    stand.add(2.0 * stream.next_unit(), 0, 0.1 + stream.next_unit(), 0.1 + stream.next_unit());
    for (const double loss : losses(name(), parameters, stand)) {
      if (name() == "nurse") {
        EXPECT_GE(loss, -0.5);
      } else {
        EXPECT_GE(loss, 0.0);
      }
      EXPECT_LE(loss, name() == "light" || name() == "combined" ? 3.0 : 1.0);
    }
  }
}

}  // namespace
}  // namespace phytobench
