// SPDX-License-Identifier: MIT
// What the presets of stands say of themselves holds when they are run.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/population/plants_file.hpp"
#include "core/population/population.hpp"
#include "core/population/population_file.hpp"
#include "reference/stand_presets.hpp"

namespace phytobench {
namespace {

/// A preset before its first step.
Population planted(const std::string& preset) {
  const PopulationFile file = read_population_file(stand_preset_file(preset));
  std::vector<StartPlant> plants;
  if (!file.plants.empty()) plants = read_plants_file(file.plants, file.parameters);
  return {file.parameters, sow(file.parameters, plants), overlap_engine_named("layered_grid")};
}

Population run(const std::string& preset) {
  Population population = planted(preset);
  while (population.state().step < population.parameters().steps) population.step();
  return population;
}

/// Of the plant with that id; 0 if it is dead.
double radius_of(const Population& population, PlantId id) {
  const Stand& stand = population.stand();
  const auto found = std::find(stand.id.begin(), stand.id.end(), id);
  return found == stand.id.end()
             ? 0.0
             : stand.stem_radius[static_cast<std::size_t>(found - stand.id.begin())];
}

/// Plants of a species nearer to any plant of another one than a distance, or further from all.
struct NearAndFar {
  int near = 0, far = 0;
};
NearAndFar count(const Stand& stand, SpeciesIndex of, SpeciesIndex to, double distance) {
  NearAndFar counts;
  for (std::size_t i = 0; i < stand.size(); ++i) {
    if (stand.species[i] != of) continue;
    bool is_near = false;
    for (std::size_t j = 0; j < stand.size(); ++j)
      is_near |= stand.species[j] == to && norm(stand.place(i) - stand.place(j)) < distance;
    ++(is_near ? counts.near : counts.far);
  }
  return counts;
}

constexpr SpeciesIndex first_species = 0, second_species = 1;

TEST(StandScenes, FlatRootsGrowSlowerThanDeepOnes) {
  const Population stand = run("roots");
  EXPECT_LT(radius_of(stand, 1), 0.5 * radius_of(stand, 0));
}

TEST(StandScenes, HealthyNeighbourOfAnIllPlantGrowsAsIfAlone) {
  const Population stand = run("disease");
  EXPECT_GT(radius_of(stand, 0), 1.05 * radius_of(stand, 1));
  EXPECT_GT(radius_of(stand, 0), 0.99 * stand.parameters().species[0].largest_radius);
}

TEST(StandScenes, HerbsGrowUnderTheOpenCrownAlone) {
  // Well inside the tree's crown at the start.
  constexpr double crown = 4.5;
  const NearAndFar before =
      count(planted("open-tree").stand(), second_species, first_species, crown);
  ASSERT_GT(before.near, 10);
  const NearAndFar open = count(run("open-tree").stand(), second_species, first_species, crown);
  const NearAndFar dense = count(run("dense-tree").stand(), second_species, first_species, crown);
  EXPECT_GT(open.near, before.near / 2);
  EXPECT_EQ(dense.near, 0);
  EXPECT_GT(dense.far, 9 * before.far / 10);
}

TEST(StandScenes, SeedlingsGrowNearNursesAloneOnlyUnderStress) {
  constexpr double zone = 5.0;
  const NearAndFar mild = count(run("nurse").stand(), second_species, first_species, zone);
  const NearAndFar harsh =
      count(run("nurse-open-ground-stress").stand(), second_species, first_species, zone);
  EXPECT_GT(mild.far, 100);
  EXPECT_GT(harsh.near, 10);
  EXPECT_EQ(harsh.far, 0);
}

TEST(StandScenes, SmallMeadowPlantsDieAmongLargeOnes) {
  constexpr SpeciesIndex large = 1, small = 2;
  constexpr double zone = 0.9;  // of a large one at half of the time
  const NearAndFar before = count(planted("influence-signs").stand(), small, large, zone);
  const NearAndFar after = count(run("influence-signs").stand(), small, large, zone);
  ASSERT_GT(before.near, 50);
  EXPECT_LT(after.near, before.near / 4);
  EXPECT_GT(after.far, 9 * before.far / 10);
}

TEST(StandScenes, BankedSeedsOutliveBadYears) {
  const Population stand = run("seed-bank");
  EXPECT_GT(stand.state().seeds.size(), 0u);
  const auto& species = stand.stand().species;
  EXPECT_EQ(std::count(species.begin(), species.end(), second_species), 0);
  EXPECT_GT(std::count(species.begin(), species.end(), first_species), 0);
}

TEST(StandScenes, TwoLargestDieInStepThirty) {
  Population stand = planted("deaths");
  while (stand.state().step < 30) stand.step();
  EXPECT_EQ(stand.stand().size(), 100u);
  std::vector<std::pair<double, PlantId>> plants;
  for (std::size_t i = 0; i < 100; ++i)
    plants.emplace_back(stand.stand().stem_radius[i], stand.stand().id[i]);
  std::sort(plants.rbegin(), plants.rend());
  stand.step();
  EXPECT_EQ(stand.stand().size(), 98u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(radius_of(stand, plants[k].second) > 0.0, k == 2) << k;
}

TEST(StandScenes, SmallPlantsDieNearLargeOnes) {
  const NearAndFar before =
      count(planted("two-species").stand(), second_species, first_species, 7.0);
  const NearAndFar after = count(run("two-species").stand(), second_species, first_species, 7.0);
  ASSERT_GT(before.near, 20);
  EXPECT_LT(after.near, before.near / 10);
  EXPECT_GT(after.far, before.far / 2);
}

TEST(StandScenes, CrowdedPlantsThinThemselves) {
  const Population stand = run("self-thinning");
  EXPECT_LT(stand.stand().size(), 100u);
  EXPECT_GT(stand.stand().size(), 10u);
}

}  // namespace
}  // namespace phytobench
