// SPDX-License-Identifier: MIT
#include "core/population/population_file.hpp"

#include <limits>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/population/population_keys.hpp"
#include "core/population/population_settings.hpp"
#include "core/population/test_population_files.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

PopulationParameters defaults() {
  PopulationParameters parameters;
  parameters.species.emplace_back().name = "oak";
  return parameters;
}

TEST(PopulationFile, OfANamedSpeciesHoldsTheDefaults) {
  const PopulationFile file = parse_population("[[species]]\nname = \"oak\"\n", "stand.toml");
  EXPECT_EQ(settings_of(file.parameters), settings_of(defaults()));
  EXPECT_EQ(file.parameters.steps, defaults().steps);
  EXPECT_EQ(file.parameters.most_plants, defaults().most_plants);
  EXPECT_TRUE(file.plants.empty());
}

TEST(PopulationFile, ExampleHoldsTheDefaultsButNameAndCount) {
  PopulationParameters expected = defaults();
  expected.species[0].count = 100;
  const PopulationParameters example = parse_stand(example_population_file());
  EXPECT_EQ(settings_of(example), settings_of(expected));
  EXPECT_EQ(example.steps, expected.steps);
}

TEST(PopulationFile, ExampleShowsEveryKeyWithMeaningUnitRangeAndSource) {
  const std::string example = example_population_file();
  std::set<std::string_view> names;
  for (const PopulationKey& key : population_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    const std::string_view value = key.example_text.empty() ? key.default_text : key.example_text;
    EXPECT_FALSE(value.empty()) << key.name;
    EXPECT_THAT(example, HasSubstr(fmt::format(
                             "{}. Unit: {}. Allowed: {}. Source: {}.\n{}{} = {}\n",
                             key.meaning.substr(1), key.unit, allowed_values(key), key.source,
                             key.shown_as_comment ? "# " : "", short_name_of(key.name), value)));
    EXPECT_EQ(key.is_required, key.default_text.empty() && !key.is_of_file_alone) << key.name;
  }
}

/// The example with the lines of its lists that are commented out, but for those that give what
/// other lines have given.
TEST(PopulationFile, ExampleStaysReadableWithItsListsInUse) {
  std::string text;
  bool is_in_lists = false;
  std::istringstream lines(example_population_file());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# [[")) is_in_lists = true;
    const bool is_key =
        line.find(" = ") != std::string::npos && line.find(". ") == std::string::npos;
    const bool repeats = line.starts_with("# share") || line.starts_with("# plants");
    if (is_in_lists && !repeats && (is_key || line.starts_with("# [["))) line.erase(0, 2);
    text += line + "\n";
  }
  const PopulationParameters read = parse_stand(text);
  ASSERT_EQ(read.events.size(), 1u);
  EXPECT_EQ(read.events[0].kind, EventKind::removal);
  EXPECT_EQ(read.events[0].step, 30);
  EXPECT_EQ(read.events[0].largest, 2);
  EXPECT_EQ(read.competition.influence_above, std::vector{Influence::harms});
}

TEST(PopulationFile, EveryDefaultMayBeWrittenOut) {
  for (const PopulationKey& key : population_keys()) {
    const bool is_alternative = key.name.ends_with("_poor") || key.name.ends_with("_rich");
    if (key.default_text.empty() || is_alternative) continue;
    SCOPED_TRACE(key.name);
    std::string text = file_with(key.name, key.default_text);
    // An event must strike something; [mortality] needs a rule.
    if (key.name.starts_with("event.")) text += "largest = 1\n";
    if (key.name.starts_with("mortality.") && key.name != "mortality.rule")
      text += "rule = \"none\"\n";
    PopulationParameters expected = defaults();
    if (key.name.starts_with("event."))
      expected.events.push_back({.kind = EventKind::removal, .step = 30, .largest = 1});
    if (key.name.starts_with("influence."))
      expected.competition.influence_above =
          expected.competition.influence_below = {Influence::harms};
    EXPECT_EQ(settings_of(parse_stand(text)), settings_of(expected));
  }
}

TEST(PopulationFile, OneFactorHoldsForPoorAndRichPlaces) {
  const Species species =
      parse_stand("[[species]]\nname = \"oak\"\nroot_factor = 12\ncrown_factor = 4\n").species[0];
  EXPECT_EQ(species.roots.poor_factor, 12.0);
  EXPECT_EQ(species.roots.rich_factor, 12.0);
  EXPECT_EQ(species.crown.poor_factor, 4.0);
  EXPECT_EQ(species.crown.rich_factor, 4.0);
}

TEST(PopulationFile, LargestAgeMayBeInfinite) {
  const auto age = [](const char* value) {
    return parse_stand(file_with("species.largest_age", value)).species[0].largest_age;
  };
  EXPECT_EQ(age("inf"), std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(age("1"), 1);
  EXPECT_EQ(age("30.0"), 30);
}

TEST(PopulationFile, RootsAreRanks) {
  const auto rank = [](const char* word) {
    return parse_stand(file_with("species.roots", word)).species[0].traits.root_rank;
  };
  EXPECT_EQ(rank("\"flat\""), 0.0);
  EXPECT_EQ(rank("\"medium\""), 0.5);
  EXPECT_EQ(rank("\"deep\""), 1.0);
}

constexpr const char* three_species = R"(
[[species]]
name = "tree"
crown_opacity = 0.25
[[species]]
name = "shrub"
count = 3
[species.reproduction]
threshold = 0.125
[[species]]
name = "herb"
)";

TEST(PopulationFile, SpeciesStandInTheOrderOfTheFileAndShareNothing) {
  const PopulationParameters read = parse_stand(three_species);
  ASSERT_EQ(read.species.size(), 3u);
  EXPECT_EQ(read.species[0].name, "tree");
  EXPECT_EQ(read.species[1].count, 3);
  EXPECT_EQ(read.species[1].traits.crown_opacity, 1.0);
  EXPECT_EQ(read.species[2].count, 0);
  EXPECT_EQ(read.species[2].reproduction.threshold, std::numeric_limits<double>::infinity());
  ASSERT_EQ(read.competition.species.size(), 3u);
  EXPECT_EQ(read.competition.species[0].crown_opacity, 0.25);
  EXPECT_TRUE(read.competition.influence_above.empty());
}

TEST(PopulationFile, LaterInfluenceOverridesEarlier) {
  const PopulationParameters read = parse_stand(std::string(three_species) + R"(
[[influence]]
of = "*"
on = "*"
above = "none"
[[influence]]
of = "tree"
on = "*"
above = "helps"
below = "none"
[[influence]]
of = "*"
on = "herb"
below = "helps"
)");
  using enum Influence;
  // Row: on whom; column: of whom.
  EXPECT_EQ(read.competition.influence_above, (std::vector<Influence>{helps, none, none,  //
                                                                      helps, none, none,  //
                                                                      helps, none, none}));
  EXPECT_EQ(read.competition.influence_below, (std::vector<Influence>{none, harms, harms,  //
                                                                      none, harms, harms,  //
                                                                      helps, helps, helps}));
}

TEST(PopulationFile, EventsNameSpecies) {
  const PopulationParameters read = parse_stand(std::string(three_species) + R"(
[[event]]
kind = "disease"
step = 4
species = "herb"
share = 0.5
[[event]]
kind = "removal"
step = 0
plants = [7, 1]
)");
  ASSERT_EQ(read.events.size(), 2u);
  EXPECT_EQ(read.events[0].species, SpeciesIndex{2});
  EXPECT_EQ(read.events[0].kind, EventKind::disease);
  EXPECT_EQ(read.events[1].plants, (std::vector<PlantId>{7, 1}));
  EXPECT_FALSE(read.events[1].species);
}

TEST(PopulationFile, TakesInlineTablesDottedKeysAndForeignLineEnds) {
  const PopulationParameters read =
      parse_stand("competition.rule = \"none\"\r\nspecies = [{name = \"oak\", count = 2}]\r\n");
  EXPECT_EQ(read.rule, "none");
  EXPECT_EQ(read.species.at(0).count, 2);
}

}  // namespace
}  // namespace phytobench
