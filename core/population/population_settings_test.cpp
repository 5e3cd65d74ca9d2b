// SPDX-License-Identifier: MIT
#include "core/population/population_settings.hpp"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using namespace testing_populations;
using Change = std::function<void(PopulationParameters&)>;

TEST(PopulationSettings, EveryKeyStandsThereOnce) {
  std::set<std::string> keys;
  for (const Setting& setting : settings_of(lively()))
    EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
  EXPECT_GT(keys.size(), 60u);
}

TEST(PopulationSettings, AChangeOfAnyParameterShows) {
  const std::vector<Change> changes = {
      [](auto& p) { p.seed = 2; },
      [](auto& p) { p.ground.high.x += 1e-9; },
      [](auto& p) { p.is_torus = false; },
      [](auto& p) { p.rule = "light"; },
      [](auto& p) { p.competition.above_share = 0.25; },
      [](auto& p) { p.competition.asymmetry_exponent = 2.0; },
      [](auto& p) { p.competition.ties = TieRule::lower_id_wins; },
      [](auto& p) { p.competition.light_constant = 2.0; },
      [](auto& p) { p.competition.field_at_rim = 0.2; },
      [](auto& p) { p.competition.influence_above = std::vector(4, Influence::none); },
      [](auto& p) { p.competition.influence_below = std::vector(4, Influence::helps); },
      [](auto& p) { std::swap(p.species[0], p.species[1]); },
      [](auto& p) { p.species.pop_back(); },
      [](auto& p) { p.species[1].name = "bush"; },
      [](auto& p) { p.species[1].count = 61; },
      [](auto& p) { p.species[1].start_radius_low = 0.01; },
      [](auto& p) { p.species[1].largest_radius = 0.51; },
      [](auto& p) { p.species[1].growth = GrowthLaw::richards; },
      [](auto& p) { p.species[1].growth_rate = 0.051; },
      [](auto& p) { p.species[1].growth_shape = 3.0; },
      [](auto& p) { p.species[1].roots.poor_factor = 14.0; },
      [](auto& p) { p.species[1].crown.exponent = 0.6; },
      [](auto& p) { p.species[1].traits.root_rank = 0.5; },
      [](auto& p) { p.species[1].largest_age = 99; },
      [](auto& p) { p.species[0].reproduction.dispersal = DispersalLaw::gaussian; },
      [](auto& p) { p.species[0].reproduction.establishment = 0.5; },
      [](auto& p) { p.mortality.rule = MortalityRule::none; },
      [](auto& p) { p.mortality.grown_up = 0.9; },
      [](auto& p) { p.illness.is_deadly = false; },
      [](auto& p) { p.bad_year_share = 0.0; },
      [](auto& p) { p.events[0].share = 0.25; },
      [](auto& p) { p.events[1].species = 0; },
      [](auto& p) { p.events.pop_back(); },
      [](auto& p) {
        p.nutrients = ResourceMap(2, 1, {0.0, 1.0}, p.ground);
      },
      [](auto& p) { p.light = ResourceMap(1, 1, {0.5}, p.ground); },
  };
  std::vector<std::vector<Setting>> seen = {settings_of(lively())};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    PopulationParameters parameters = lively();
    changes[i](parameters);
    seen.push_back(settings_of(parameters));
    for (std::size_t j = 0; j <= i; ++j) EXPECT_NE(seen.back(), seen[j]) << i << " and " << j;
  }
}

TEST(PopulationSettings, MapsOfOneSizeDifferByTheirValues) {
  PopulationParameters a = lively(), b = lively();
  a.nutrients = ResourceMap(2, 1, {0.0, 1.0}, a.ground);
  b.nutrients = ResourceMap(2, 1, {1.0, 0.0}, b.ground);
  EXPECT_NE(settings_of(a), settings_of(b));
}

TEST(PopulationSettings, MoreStepsAndRoomAreTheSameRun) {
  PopulationParameters longer = lively();
  longer.steps += 100;
  longer.most_plants += 1;
  EXPECT_EQ(settings_of(longer), settings_of(lively()));
}

TEST(PopulationSettings, TheDigestIsTheKnownOne) {
  EXPECT_EQ(digest(""), 0xcbf29ce484222325ULL);  // published test vectors of FNV-1a
  EXPECT_EQ(digest("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(digest("foobar"), 0x85944171f73967e8ULL);
  EXPECT_EQ(digest("bar", digest("foo")), digest("foobar"));
}

}  // namespace
}  // namespace phytobench
