// SPDX-License-Identifier: MIT
#include "core/population/stand_statistics.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using namespace testing_populations;

using std::numbers::pi;

Stand stand_of(const std::vector<double>& radii, const std::vector<SpeciesIndex>& species) {
  Stand stand;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    stand.x.push_back(static_cast<double>(i));
    stand.y.push_back(0.5);
    stand.stem_radius.push_back(radii[i]);
    stand.id.push_back(i);
    stand.age.push_back(0);
    stand.ill_since.push_back(healthy);
    stand.species.push_back(species[i]);
  }
  return stand;
}

TEST(StandStatistics, AreThoseOfTheirPlants) {
  const Stand stand = stand_of({0.1, 0.3, 0.2}, {1, 1, 0});
  const std::vector<double> loss = {0.75, -0.25, 0.5};
  const StandStatistics found = stand_statistics(stand, loss, 3, 50.0);
  ASSERT_EQ(found.species.size(), 3u);
  const PlantStatistics& second = found.species[1];
  EXPECT_EQ(second.plants, 2u);
  EXPECT_DOUBLE_EQ(second.density, 0.04);
  EXPECT_DOUBLE_EQ(second.mean_radius, 0.2);
  EXPECT_DOUBLE_EQ(second.largest_radius, 0.3);
  EXPECT_DOUBLE_EQ(second.basal_area, pi * 0.1);
  EXPECT_DOUBLE_EQ(second.gini, 0.4);  // areas 1 and 9: mean difference 4, mean 5
  EXPECT_DOUBLE_EQ(second.mean_loss, 0.25);
  EXPECT_DOUBLE_EQ(second.oppressed_share, 0.5);
  EXPECT_EQ(found.species[0].oppressed_share, 0.0);  // one half is not more than one half
  EXPECT_EQ(found.species[0].gini, 0.0);
  EXPECT_EQ(found.all.plants, 3u);
  EXPECT_DOUBLE_EQ(found.all.mean_loss, 1.0 / 3.0);
}

TEST(StandStatistics, OfNoPlantsHaveNoMeans) {
  const PlantStatistics none = stand_statistics(Stand(), {}, 1, 1.0).species[0];
  EXPECT_EQ(none.plants, 0u);
  EXPECT_EQ(none.density, 0.0);
  EXPECT_EQ(none.basal_area, 0.0);
  for (const double mean :
       {none.mean_radius, none.largest_radius, none.gini, none.mean_loss, none.oppressed_share})
    EXPECT_TRUE(std::isnan(mean));
}

TEST(StandStatistics, OfSpeciesAddUpToThoseOfAll) {
  Population population = after(lively(), 10);
  const StandStatistics found =
      stand_statistics(population.stand(), population.losses(), 2, 3600.0);
  EXPECT_GT(found.species[0].plants, 0u);
  EXPECT_EQ(found.species[0].plants + found.species[1].plants, found.all.plants);
  EXPECT_NEAR(found.species[0].basal_area + found.species[1].basal_area, found.all.basal_area,
              1e-12 * found.all.basal_area);
  EXPECT_EQ(found.all.largest_radius,
            std::max(found.species[0].largest_radius, found.species[1].largest_radius));
}

TEST(StandStatistics, RefuseListsOfOtherLengths) {
  EXPECT_THROW(stand_statistics(stand_of({1.0}, {0}), {}, 1, 1.0), ContractViolation);
  EXPECT_THROW(stand_statistics(stand_of({1.0}, {1}), std::vector{0.0}, 1, 1.0), ContractViolation);
}

TEST(StandPattern, KnowsASquareLattice) {
  Stand stand;
  for (int i = 0; i < 400; ++i) {
    stand.x.push_back(i % 20 + 0.25);
    stand.y.push_back(i / 20 + 0.75);
    stand.id.push_back(static_cast<PlantId>((i * 7) % 400));
  }
  const StandPattern torus = stand_pattern(stand, {{0, 0}, {20, 20}}, true);
  EXPECT_NEAR(torus.mean_nearest_distance, 1.0, 1e-12);
  EXPECT_NEAR(torus.hopkins, 0.38259785823210635, 1e-12);  // (sqrt 2 + asinh 1) / 6
  EXPECT_NEAR(torus.clark_evans, 2.0, 0.01);
  const StandPattern plot = stand_pattern(stand, {{0, 0}, {20, 20}}, false);
  EXPECT_LT(plot.clark_evans, torus.clark_evans);  // edges make chance distances longer
}

TEST(StandPattern, DoesNotDependOnThreadsOrOnTheOrderOfPlants) {
  const Population population = population_of(one_species(300));
  const Rectangle& ground = population.parameters().ground;
  Stand stand = population.stand();
  const StandPattern first = stand_pattern(stand, ground, true);
  EXPECT_NEAR(first.clark_evans, 1.0, 0.1);
  std::swap(stand.x[3], stand.x[5]);
  std::swap(stand.y[3], stand.y[5]);
  std::swap(stand.id[3], stand.id[5]);
  const StandPattern second = stand_pattern(stand, ground, true, 3);
  EXPECT_EQ(first.hopkins, second.hopkins);
  EXPECT_EQ(first.clark_evans, second.clark_evans);
}

TEST(StandPattern, OfOnePlantIsNone) {
  EXPECT_TRUE(std::isnan(stand_pattern(stand_of({1.0}, {0}), {{0, 0}, {2, 2}}, true).hopkins));
}

}  // namespace
}  // namespace phytobench
