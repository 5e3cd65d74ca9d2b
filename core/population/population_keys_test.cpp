// SPDX-License-Identifier: MIT
#include "core/population/population_keys.hpp"

#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/population/population_settings.hpp"
#include "core/population/test_population_files.hpp"

namespace phytobench {
namespace {

/// Another value than the default for every key whose place the table knows.
const std::map<std::string_view, const char*> other_values = {
    {"seed", "9007199254740991"},
    {"steps", "70"},
    {"ground.size", "[60.5, 40]"},
    {"ground.corner", "[-3, 1000000]"},
    {"ground.torus", "false"},
    {"competition.rule", "\"asymmetric\""},
    {"competition.above_share", "0.25"},
    {"competition.asymmetry_exponent", "inf"},
    {"competition.ties", "\"lower-id-wins\""},
    {"competition.light_constant", "3"},
    {"competition.field_at_rim", "0.2"},
    {"mortality.rule", "\"mean-relative-growth\"\nthreshold = 1.0"},
    {"mortality.window", "7\nrule = \"none\""},
    {"mortality.threshold", "0.125\nrule = \"mean-size\""},
    {"mortality.grown_up", "0.5\nrule = \"none\""},
    {"illness.duration", "3"},
    {"illness.is_deadly", "true"},
    {"seasons.bad_year_share", "0.3"},
    {"species.name", "\"fern\""},
    {"species.count", "7"},
    {"species.start_radius", "[0.01, 0.01]"},
    {"species.largest_radius", "2"},
    {"species.growth", "\"richards\""},
    {"species.growth_rate", "0.25"},
    {"species.growth_shape", "1"},
    {"species.largest_age", "30"},
    {"species.root_factor_poor", "3\nroot_factor_rich = 1.0"},
    {"species.root_factor_rich", "3\nroot_factor_poor = 1.0"},
    {"species.root_exponent", "1"},
    {"species.crown_factor_poor", "3\ncrown_factor_rich = 1.0"},
    {"species.crown_factor_rich", "3\ncrown_factor_poor = 1.0"},
    {"species.crown_exponent", "0.75"},
    {"species.crown_opacity", "0.5"},
    {"species.roots", "\"medium\""},
    {"species.open_ground_stress", "0.6"},
    {"species.reproduction.threshold", "0.25"},
    {"species.reproduction.seeds_per_metre", "20\nthreshold = 0.1"},
    {"species.reproduction.dispersal", "\"gaussian\""},
    {"species.reproduction.dispersal_distance", "8"},
    {"species.reproduction.seed_mortality", "0.1"},
    {"species.reproduction.dormant_share", "0.4"},
    {"species.reproduction.germination_rate", "0.3"},
    {"species.reproduction.establishment", "0.5"},
    {"species.reproduction.seedling_radius", "0.01"},
    {"event.kind", "\"disease\"\nlargest = 1"},
    {"event.step", "2\nlargest = 1"},
    {"event.largest", "3"},
    {"event.share", "0.5"},
    {"event.plants", "[4, 2]"},
};

/// What the key's place holds, as it would be written.
std::string written(const PopulationKey& key, PopulationFileValues& values) {
  return std::visit(
      Overloaded{
          [&](const PopulationNumber& kind) { return fmt::format("{}", kind.value(values)); },
          [&](const PopulationPair& kind) {
            const Point2 pair = kind.value(values);
            return fmt::format("[{}, {}]", pair.x, pair.y);
          },
          [&](const PopulationChoice& kind) {
            return fmt::format("\"{}\"", kind.words[kind.chosen(values)]);
          },
          [&](const PopulationSwitch& kind) { return fmt::format("{}", kind.place(values)); },
          [&](const PopulationText& kind) { return fmt::format("\"{}\"", kind.place(values)); },
          [&](const PopulationFileName& kind) { return kind.place(values); },
          [&](const PopulationIds& kind) {
            return fmt::format("[{}, {}]", kind.place(values)[0], kind.place(values)[1]);
          }},
      key.kind);
}

/// The settings of a run that differ, by their keys.
std::set<std::string> changed(const PopulationParameters& a, const PopulationParameters& b) {
  const std::vector<Setting> of_a = settings_of(a), of_b = settings_of(b);
  std::set<std::string> keys;
  for (std::size_t i = 0; i < of_a.size(); ++i)
    if (of_a[i] != of_b.at(i)) keys.insert(of_a[i].key);
  return keys;
}

/// The keys of settings that a text "0.5\nkey = 1" for the named key is meant to change.
std::set<std::string> meant(std::string_view name, const std::string& text) {
  std::string section(section_of(name));
  if (section.starts_with("species")) section.replace(0, 7, "species.oak");
  const std::string prefix = section.empty() ? "" : section + ".";
  std::set<std::string> keys{prefix + std::string(short_name_of(name))};
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1))
    if (text.substr(end + 1) != "rule = \"none\"")
      keys.insert(prefix + text.substr(end + 1, text.find(' ', end) - end - 1));
  return keys;
}

TEST(PopulationKeys, ReachTheirPlaceWithTheValueOfTheFile) {
  std::size_t reached = 0;
  for (const PopulationKey& key : population_keys()) {
    const auto other = other_values.find(key.name);
    if (other == other_values.end()) continue;
    SCOPED_TRACE(key.name);
    const std::string value = other->second;
    PopulationFileValues read = file_values_of(parse_stand(file_with(key.name, value)));
    read.species = read.parameters.species.at(0);
    if (key.name.starts_with("event.")) read.event = read.parameters.events.at(0);
    EXPECT_EQ(written(key, read), value.substr(0, value.find('\n')));
    ++reached;
  }
  EXPECT_EQ(reached, other_values.size());
  // Beside these are names of files and species, signs, and factors for two places at once.
  EXPECT_EQ(population_keys().size() - reached, 10u);
}

// Values alone would not notice two keys that share one place.
TEST(PopulationKeys, ReachNoOtherPlace) {
  const PopulationParameters before = parse_stand("[[species]]\nname = \"oak\"\n");
  for (const auto& [name, value] : other_values) {
    // These have settings of other names, or none.
    if (name == "steps" || name == "species.name" || name == "ground.size" ||
        name == "ground.corner" || name.starts_with("event."))
      continue;
    EXPECT_EQ(changed(before, parse_stand(file_with(name, value))), meant(name, value)) << name;
  }
  using testing::ElementsAre;
  EXPECT_THAT(changed(before, parse_stand(file_with("ground.size", "[9.0, 8.0]"))),
              ElementsAre("ground's far corner"));
  EXPECT_EQ(parse_stand(file_with("steps", "7")).steps, 7);
  EXPECT_THAT(changed(before, parse_stand(file_with("steps", "7"))), ElementsAre());
  EXPECT_EQ(parse_stand(file_with("ground.corner", "[3.0, 4.0]")).ground,
            (Rectangle{{3.0, 4.0}, {203.0, 204.0}}));
}

TEST(PopulationKeys, DefaultsAreThoseOfTheParameters) {
  PopulationFileValues defaults;
  for (const PopulationKey& key : population_keys()) {
    const auto* number = std::get_if<PopulationNumber>(&key.kind);
    if (number == nullptr || key.is_required || key.default_text.empty()) continue;
    if (key.name.ends_with("_rich")) continue;  // what the example shows beside _poor
    EXPECT_EQ(fmt::format("{}", number->value(defaults)),
              fmt::format("{}", std::stod(std::string(key.default_text))))
        << key.name;
  }
}

}  // namespace
}  // namespace phytobench
