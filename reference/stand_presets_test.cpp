// SPDX-License-Identifier: MIT
#include "reference/stand_presets.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/plants_file.hpp"
#include "core/population/population_file.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

PopulationFile preset_stand(const std::string& name) {
  return read_population_file(stand_preset_file(name));
}

TEST(StandPresets, AreThereForEveryScene) {
  std::set<std::string> names;
  for (const StandPreset& one : stand_presets()) names.insert(one.name);
  for (const char* scene :
       {"five-regions-symmetric", "five-regions-asymmetric", "five-regions-mixture", "two-species",
        "deaths", "seed-bank", "tree-shrubs-meadow-flowers", "influence-signs", "open-tree",
        "dense-tree", "roots", "nurse", "nurse-open-ground-stress", "disease", "self-thinning",
        "million"})
    EXPECT_TRUE(names.contains(scene)) << scene;
}

TEST(StandPresets, CanBeReadWithTheirPlantsAndSayWhatTheyAre) {
  std::set<std::string> names;
  for (const StandPreset& one : stand_presets()) {
    SCOPED_TRACE(one.name);
    const PopulationFile file = read_population_file(one.file);
    EXPECT_NO_THROW(check_parameters(file.parameters));
    std::int64_t plants = 0;
    for (const Species& species : file.parameters.species) plants += species.count;
    if (!file.plants.empty()) plants += std::ssize(read_plants_file(file.plants, file.parameters));
    EXPECT_GT(plants, 0);
    EXPECT_GT(one.summary.size(), 20u);
    EXPECT_TRUE(names.insert(one.name).second);
  }
}

TEST(StandPresets, AnUnknownNameGetsTheClosestOne) {
  EXPECT_EQ(stand_preset_file("deaths").filename(), "deaths.toml");
  try {
    stand_preset_file("million-");
    ADD_FAILURE() << "an unknown preset was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown preset 'million-'; did you mean 'million'?"));
    EXPECT_THAT(error.what(), testing::EndsWith("see phytobench list stands"));
  }
}

TEST(StandPresets, HaveTheNumbersOfPlantsAndTheGroundsThatArePublished) {
  for (const char* name :
       {"five-regions-symmetric", "five-regions-asymmetric", "five-regions-mixture"}) {
    const PopulationParameters stand = preset_stand(name).parameters;
    EXPECT_EQ(stand.ground.width(), 200.0);
    EXPECT_EQ(stand.ground.height(), 200.0);
    EXPECT_EQ(stand.species.at(0).count, 100);
  }
  const PopulationFile meadow = preset_stand("tree-shrubs-meadow-flowers");
  EXPECT_EQ(meadow.parameters.ground.width(), 60.0);
  EXPECT_EQ(meadow.parameters.ground.height(), 60.0);
  EXPECT_EQ(read_plants_file(meadow.plants, meadow.parameters).size(), 1u);
  const auto& species = meadow.parameters.species;
  ASSERT_EQ(species.size(), 4u);
  EXPECT_EQ(species[0].count, 0);  // the tree stands in the file of plants
  EXPECT_EQ(species[1].count, 155);
  EXPECT_EQ(species[2].count, 4000);
  EXPECT_EQ(species[3].count, 200);
}

// From the richest to the poorest: I, III, II, IV and VI in the middle.
TEST(StandPresets, FiveRegionsHaveFiveSoils) {
  const PopulationParameters stand = preset_stand("five-regions-mixture").parameters;
  const ZoneLaw& roots = stand.species.at(0).roots;
  const auto factor = [&](double x, double y) {
    return roots.poor_factor + stand.nutrients.at({x, y}) * (roots.rich_factor - roots.poor_factor);
  };
  // Half a grey level.
  constexpr double rounding = 0.5 / 255.0 * (15.0 - 6.0);
  EXPECT_EQ(factor(20.0, 180.0), 6.0);
  EXPECT_NEAR(factor(20.0, 20.0), 8.0, rounding);
  EXPECT_NEAR(factor(180.0, 180.0), 10.0, rounding);
  EXPECT_NEAR(factor(180.0, 20.0), 12.5, rounding);
  EXPECT_EQ(factor(100.0, 100.0), 15.0);
  // The poorest is a disc of 50 m.
  EXPECT_EQ(factor(100.0, 51.0), 15.0);
  EXPECT_LT(factor(99.0, 49.0), 8.1);
  const std::set<double> levels(stand.nutrients.values().begin(), stand.nutrients.values().end());
  EXPECT_EQ(levels.size(), 5u);
}

}  // namespace
}  // namespace phytobench
