// SPDX-License-Identifier: MIT
#include "core/population/population_parameters.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Parameters = PopulationParameters;

constexpr double infinite_value = std::numeric_limits<double>::infinity();

/// Two species that may live.
Parameters sound() {
  Parameters parameters;
  for (const char* name : {"oak", "fern"}) {
    parameters.species.emplace_back().name = name;
    parameters.species.back().count = 10;
  }
  return parameters;
}

/// What is said when something is changed in sound parameters.
std::string complaint(const std::function<void(Parameters&)>& change) {
  Parameters parameters = sound();
  change(parameters);
  try {
    check_parameters(parameters);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    return error.what();
  }
  return "none";
}

/// The same for the second species.
std::string complaint_on_fern(const std::function<void(Species&)>& change) {
  return complaint([&](Parameters& p) { change(p.species[1]); });
}

TEST(PopulationParameters, OfSoundSpeciesAreAllowed) {
  EXPECT_EQ(complaint([](Parameters&) {}), "none");
  EXPECT_EQ(complaint([](Parameters& p) { p.seed = ~std::uint64_t{0}; }), "none");
  EXPECT_EQ(complaint([](Parameters& p) { p.steps = 0; }), "none");
}

TEST(PopulationParameters, NeedASpecies) {
  EXPECT_EQ(complaint([](Parameters& p) { p.species.clear(); }),
            "there is no species; give at least one [[species]]");
  EXPECT_THAT(complaint([](Parameters& p) {
                for (int i = 0; i < 2000; ++i)
                  p.species.emplace_back().name = "s" + std::to_string(i);
              }),
              StartsWith("2002 species are too many"));
}

TEST(PopulationParameters, SpeciesHaveNamesOfTheirOwnThatTablesCanHold) {
  for (const char* name : {"", "*", "a,b", "a\"b", " oak", "oak ", "a\nb", "\t", "\x1b[1m"})
    EXPECT_THAT(complaint_on_fern([&](Species& s) { s.name = name; }),
                AllOf(HasSubstr("species.name = '"), HasSubstr("is not allowed")))
        << name;
  EXPECT_THAT(complaint_on_fern([](Species& s) { s.name = std::string(101, 'x'); }),
              HasSubstr("is not allowed"));
  for (const std::string& name :
       {std::string("K\xc3\xbcstentanne"), std::string("red oak"), std::string(100, 'x')})
    EXPECT_EQ(complaint_on_fern([&](Species& s) { s.name = name; }), "none");
  EXPECT_EQ(complaint_on_fern([](Species& s) { s.name = "oak"; }),
            "there are two species 'oak'; rename one");
}

TEST(PopulationParameters, GroundIsARectangleOfAtMostAMillionMetres) {
  const auto with_ground = [](Rectangle ground) {
    return complaint([&](Parameters& p) { p.ground = ground; });
  };
  EXPECT_EQ(with_ground({{0.0, 0.0}, {1e6, 0.001}}), "none");
  // 1e9 + 1e6 is rounded.
  EXPECT_EQ(with_ground({{1e9 - 0.3, -1e9}, {1e9 - 0.3 + 1e6, -1e9 + 1e6}}), "none");
  for (const Rectangle& wrong :
       {Rectangle{{0, 0}, {0, 1}}, Rectangle{{0, 0}, {1, -1}}, Rectangle{{0, 0}, {1e6 + 1, 1}},
        Rectangle{{0, 0}, {infinite_value, 1}}, Rectangle{{0, 0}, {1, std::nan("")}},
        Rectangle{{1e9, 0}, {1e9 + 1e-9, 1}}})
    EXPECT_THAT(with_ground(wrong), StartsWith("ground.size = "));
  EXPECT_THAT(with_ground({{2e9, 0.0}, {2e9 + 1, 1.0}}), StartsWith("ground.corner = 2000000000"));
}

// Every number of the table, set to what is just beyond its range.
TEST(PopulationParameters, NumbersBeyondTheirRangeAreInputErrorsThatNameTheKey) {
  int checked = 0;
  for (const PopulationKey& key : population_keys()) {
    const auto* number = std::get_if<PopulationNumber>(&key.kind);
    if (number == nullptr || key.is_of_file_alone) continue;
    const NumberRange& range = number->range;
    std::vector<double> beyond;
    if (range.whole)
      beyond = {range.low - 1.0, range.high + 1.0};
    else
      beyond = {range.low - 0.5, range.high + 0.5, std::nan(""), -infinite_value};
    if (!range.low_is_allowed) beyond.push_back(range.low);
    if (!range.high_is_allowed) beyond.push_back(range.high);
    if (!range.whole && !range.infinity_is_allowed) beyond.push_back(infinite_value);
    for (const double value : beyond) {
      PopulationFileValues values = file_values_of(sound());
      values.species = values.parameters.species[1];
      values.event.largest = 1;
      number->assign(values, value);
      const std::string message = complaint([&](Parameters& p) {
        p = values.parameters;
        p.species[1] = values.species;
        if (key.name.starts_with("event.")) p.events.push_back(values.event);
      });
      EXPECT_THAT(message, HasSubstr(out_of_range(key.name, value, range)));
      EXPECT_EQ(message.starts_with("species 'fern': "), key.name.starts_with("species."));
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(PopulationParameters, PlantsAreAtMostAsManyAsAllowed) {
  EXPECT_EQ(complaint([](Parameters& p) { p.most_plants = 20; }), "none");
  EXPECT_EQ(complaint([](Parameters& p) { p.most_plants = 19; }),
            "species.count adds up to 20 plants; give at most 19");
}

TEST(PopulationParameters, StartRadiiAreOrderedAndAtMostTheLargest) {
  EXPECT_THAT(complaint_on_fern([](Species& s) { s.start_radius_low = 0.08; }),
              StartsWith("species 'fern': species.start_radius = [0.08, 0.07] begins with"));
  EXPECT_THAT(complaint_on_fern([](Species& s) { s.largest_radius = 0.06; }),
              HasSubstr("species.start_radius = 0.07 exceeds species.largest_radius = 0.06"));
  EXPECT_EQ(complaint_on_fern([](Species& s) { s.largest_radius = 0.07; }), "none");
}

TEST(PopulationParameters, OneStepOfGrowthDoesNotOvershoot) {
  EXPECT_EQ(complaint_on_fern([](Species& s) { s.growth_rate = 0.5; }), "none");
  EXPECT_THAT(complaint_on_fern([](Species& s) { s.growth_rate = 0.51; }),
              HasSubstr("species.growth_rate = 0.51 in a step exceeds species.largest_radius"));
  EXPECT_EQ(complaint_on_fern([](Species& s) { s.growth_rate = 0.0; }), "none");
  EXPECT_THAT(complaint_on_fern([](Species& s) {
                s.growth_rate = 0.0;
                s.growth = GrowthLaw::richards;
              }),
              HasSubstr("is no growth by Richards' law"));
}

TEST(PopulationParameters, SeedsNeedPlantsThatBearThem) {
  const auto with_seeds = [](double threshold, double seedling) {
    return complaint_on_fern([&](Species& s) {
      s.reproduction.seeds_per_metre = 3.0;
      s.reproduction.threshold = threshold;
      s.reproduction.seedling_radius = seedling;
    });
  };
  EXPECT_EQ(with_seeds(0.25, 0.001), "none");
  for (const double threshold : {0.5, infinite_value})
    EXPECT_THAT(with_seeds(threshold, 0.001), HasSubstr("no plant would bear seeds"));
  EXPECT_THAT(with_seeds(0.25, 0.5), HasSubstr("species.reproduction.seedling_radius = 0.5 is not "
                                               "below species.largest_radius = 0.5"));
  // Without seeds neither matters.
  EXPECT_EQ(complaint_on_fern([](Species& s) { s.reproduction.seedling_radius = 1.0; }), "none");
}

TEST(PopulationParameters, RuleMustBeOneOfTheSuite) {
  EXPECT_THAT(complaint([](Parameters& p) { p.rule = "mixtrue"; }),
              StartsWith("unknown rule 'mixtrue'; did you mean 'mixture'?"));
  EXPECT_EQ(complaint([](Parameters& p) { p.rule = "none"; }), "none");
}

TEST(PopulationParameters, CompetitionIsCheckedForTheirSpecies) {
  const auto with_table = [](std::size_t entries) {
    return complaint([&](Parameters& p) {
      p.competition.influence_above.assign(entries, Influence::none);
      p.competition.species.resize(7);  // those of `species` count
    });
  };
  EXPECT_EQ(with_table(4), "none");
  EXPECT_THAT(with_table(49), StartsWith("influence.above has 49 entries"));
}

TEST(PopulationParameters, MortalityNeedsAThreshold) {
  EXPECT_THAT(complaint([](Parameters& p) { p.mortality.rule = MortalityRule::mean_growth; }),
              StartsWith("mortality.threshold = 0 lets no plant die"));
  EXPECT_EQ(complaint([](Parameters& p) {
              p.mortality.rule = MortalityRule::mean_size;
              p.mortality.threshold = 1e-9;
            }),
            "none");
}

std::string complaint_on_event(const PopulationEvent& event) {
  return complaint([&](Parameters& p) { p.events.push_back(event); });
}

TEST(PopulationParameters, EventsStrikePlantsInExactlyOneWay) {
  EXPECT_EQ(complaint_on_event({.plants = {3}}), "none");
  EXPECT_EQ(complaint_on_event({.species = SpeciesIndex{1}, .largest = 2}), "none");
  EXPECT_EQ(complaint_on_event({.species = SpeciesIndex{1}, .share = 1.0}), "none");
  EXPECT_THAT(complaint_on_event({}), HasSubstr("none of them strike plants; give exactly one"));
  for (const PopulationEvent& event :
       {PopulationEvent{.plants = {3}, .largest = 2}, PopulationEvent{.plants = {3}, .share = 0.1},
        PopulationEvent{.largest = 1, .share = 0.1}})
    EXPECT_THAT(complaint_on_event(event), HasSubstr("several of them strike plants"));
}

TEST(PopulationParameters, EventsOutOfRangeAreInputErrors) {
  EXPECT_THAT(complaint_on_event({.step = -1, .largest = 1}), StartsWith("event.step = -1 is not"));
  EXPECT_THAT(complaint_on_event({.largest = -2}), StartsWith("event.largest = -2"));
  for (const double share : {-0.1, 1.1, std::nan(""), infinite_value})
    EXPECT_THAT(complaint_on_event({.share = share}), HasSubstr("is not allowed"));
  EXPECT_EQ(complaint_on_event({.species = SpeciesIndex{2}, .largest = 1}),
            "event.species is number 3 of 2 species");
  EXPECT_THAT(complaint_on_event({.species = SpeciesIndex{1}, .plants = {3}}),
              StartsWith("event.species does not go with event.plants"));
}

}  // namespace
}  // namespace phytobench
