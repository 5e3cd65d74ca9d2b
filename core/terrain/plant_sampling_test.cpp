// SPDX-License-Identifier: MIT
#include "core/terrain/plant_sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/contract/errors.hpp"
#include "core/population/plants_file.hpp"
#include "core/population/population_parameters.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

TerrainMap even_chances(const HeightField& heights, double chance) {
  return {heights.columns(), heights.rows(), std::vector<double>(heights.size(), chance)};
}

double distance_between(const SampledPlant& a, const SampledPlant& b) {
  return std::hypot(a.east - b.east, a.south - b.south);
}

/// Cells that are not square, two maps, and a hole in one of them.
class PlantSamplingOnGround : public testing::Test {
 protected:
  PlantSamplingOnGround()
      : heights_(20, 10, 5.0, 4.0),
        trees_(even_chances(heights_, 0.8)),
        herbs_(even_chances(heights_, 0.5)) {
    trees_.values[0] = HeightField::no_data;
    for (std::size_t i = 100; i < 200; ++i) herbs_.values[i] = 0.0;
  }

  std::vector<SampledPlant> sampled(const PlantSampling& sampling) const {
    const std::array<SampledSpecies, 2> species{SampledSpecies{&trees_, 6.0},
                                                SampledSpecies{&herbs_, 1.5}};
    return sampled_plants(heights_, species, sampling);
  }

  HeightField heights_;
  TerrainMap trees_, herbs_;
};

TEST_F(PlantSamplingOnGround, KeepsPlantsApart) {
  const auto plants = sampled({.seed = 3, .number = 400.0});
  ASSERT_GT(plants.size(), 100u);
  const std::array<double, 2> spacing{6.0, 1.5};
  for (std::size_t i = 0; i < plants.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(distance_between(plants[i], plants[j]),
                0.5 * (spacing[plants[i].species] + spacing[plants[j].species]))
          << i << " " << j;
}

TEST_F(PlantSamplingOnGround, NothingGrowsWhereThereIsNoChance) {
  for (const SampledPlant& plant : sampled({.seed = 4, .number = 300.0})) {
    const auto column = static_cast<int>(plant.east / 5.0),
               row = static_cast<int>(plant.south / 4.0);
    EXPECT_GT((plant.species == 0 ? trees_ : herbs_).at(column, row), 0.0) << column << " " << row;
  }
}

TEST_F(PlantSamplingOnGround, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const PlantSampling sampling{.seed = 5, .number = 100.0};
  EXPECT_EQ(sampled(sampling), sampled(sampling));
  EXPECT_NE(sampled(sampling), sampled({.seed = 6, .number = 100.0}));
  // More of them begin with the same.
  auto more = sampled({.seed = 5, .number = 150.0});
  const auto fewer = sampled(sampling);
  ASSERT_GT(more.size(), fewer.size());
  more.resize(fewer.size());
  EXPECT_EQ(more, fewer);
}

TEST_F(PlantSamplingOnGround, SaysHowManyAreWanted) {
  const std::array<SampledSpecies, 2> species{SampledSpecies{&trees_, 6.0},
                                              SampledSpecies{&herbs_, 1.5}};
  EXPECT_EQ(sampled_number(heights_, species, {.number = 1e6}), 1e6);
  // 199 cells with 0.8 and 100 with 0.5, of 20 m2 each: 0.4184 hectares.
  EXPECT_EQ(sampled_number(heights_, species, {.number = 100.0, .is_per_hectare = true}), 42.0);
}

TEST_F(PlantSamplingOnGround, EndsWhereThereIsNoRoomAndWithoutAnyChance) {
  const auto plants = sampled({.number = 1e6});
  EXPECT_LT(plants.size(), 2000u);  // 800 herbs stand 1.5 m apart in 2000 m2 at most
  EXPECT_GT(plants.size(), 400u);
  const TerrainMap none = even_chances(heights_, HeightField::no_data);
  const SampledSpecies species{&none, 1.0};
  EXPECT_TRUE(sampled_plants(heights_, {&species, 1}, {}).empty());
}

/// Far below what would fill the ground, spacing does not matter.
TEST(PlantSampling, IsAsDenseAsTheChanceSays) {
  const HeightField heights(40, 25, 10.0, 10.0);
  TerrainMap chance = even_chances(heights, 0.0);
  // Every fifth column has the chance 0.2, 0.4, ... 1: a fifth of each class' plants for its
  // chance.
  const auto class_of = [](int column) { return column % 5; };
  for (int row = 0; row < heights.rows(); ++row)
    for (int column = 0; column < heights.columns(); ++column)
      chance.values[heights.index(column, row)] = 0.2 * (class_of(column) + 1);
  const SampledSpecies species{&chance, 0.01};
  const auto plants = sampled_plants(heights, {&species, 1}, {.seed = 1, .number = 15'000.0});
  ASSERT_EQ(plants.size(), 15'000u);
  // Cells of equal likelihood: a class with chance 0.2 k is split into k parts along a row's cell.
  std::vector<std::int64_t> counts(15);
  for (const SampledPlant& plant : plants) {
    const int parts = class_of(static_cast<int>(plant.east / 10.0)) + 1;
    const double within = plant.east / 10.0 - std::floor(plant.east / 10.0);
    ++counts[static_cast<std::size_t>(parts * (parts - 1) / 2 + static_cast<int>(within * parts))];
  }
  EXPECT_GT(uniformity_p_value(counts), 0.001);
  // The test can fail: to believe in equal chances would be seen.
  std::vector<std::int64_t> by_class(5);
  for (const SampledPlant& plant : plants)
    ++by_class[static_cast<std::size_t>(class_of(static_cast<int>(plant.east / 10.0)))];
  EXPECT_LT(uniformity_p_value(by_class), 1e-9);
}

TEST(PlantSampling, CountsDartsByTheHectare) {
  const HeightField heights(100, 100, 10.0, 10.0);  // 100 ha
  const TerrainMap chance = even_chances(heights, 0.25);
  const SampledSpecies species{&chance, 0.0};
  const PlantSampling sampling{.number = 40.0, .is_per_hectare = true};
  EXPECT_EQ(sampled_plants(heights, {&species, 1}, sampling).size(), 1000u);
  EXPECT_THROW(sampled_plants(heights, {&species, 1}, {.number = 9e6, .is_per_hectare = true}),
               InputError);
}

TEST(PlantSampling, CompeteReadsTheTable) {
  const HeightField heights(3, 2, 10.0, 5.0);
  const std::vector<SampledPlant> plants{{1.0, 2.0, 1}, {29.5, 9.5, 0}};
  const std::array<PlantColumns, 2> species{PlantColumns{"oak", 0.1}, PlantColumns{"herb", 0.01}};
  const std::string csv = sampled_plants_csv(heights, plants, species);
  EXPECT_EQ(csv, "x,y,radius,species\n1,8,0.01,herb\n29.5,0.5,0.1,oak\n");
  const std::string file = testing::TempDir() + "sampled" + std::to_string(::getpid()) + ".csv";
  std::ofstream(file) << csv;
  PopulationParameters parameters;
  parameters.ground = {{0.0, 0.0}, {30.0, 10.0}};
  for (const PlantColumns& one : species)
    parameters.species.push_back({.name = std::string(one.name)});
  const std::vector<StartPlant> read = read_plants_file(file, parameters);
  std::remove(file.c_str());
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].place.y, 8.0);
  EXPECT_EQ(read[0].species, 1u);
  EXPECT_EQ(read[1].stem_radius, 0.1);
}

}  // namespace
}  // namespace phytobench
