// SPDX-License-Identifier: MIT
#include "core/terrain/site_maps.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench {
namespace {

// [Lesser2019] listings 9.3, 9.4 and 9.6.
const Biome polar_zone{"PolarZone", 45.0, 8.0, 40.0, DailyWater(1.5), DailyWater(1.0)};
const Soil dirt{"Dirt", 40, 0.25, 0.38};
const PlantSpecies apple_tree{"Appletree", DailyEnergy(2000.0), DailyWater(0.7), "Dirt",
                              centimetres(80.0)};

SiteInput flat_site() {
  SiteInput site;
  site.heights = HeightField(5, 5, 16.0, 16.0, 100.0);
  site.soils = {dirt};
  site.soil_of.assign(25, 0);
  site.biome = polar_zone;
  return site;
}

SiteMaps maps_of(const SiteInput& site, const SiteModel& model, int threads = 1) {
  const SiteOptions options{.suns = model.sun_path({}), .threads = threads};
  return site_maps(site, options, model, *shadow_engine_named("exact_traversal").create());
}

// Every number of [Lesser2019] on a flat polar site, with what is corrected here.
TEST(SiteMaps, FollowTheWorkedExample) {
  const SiteInput site = flat_site();
  const auto model = corrected_site_model();
  const SiteMaps maps = maps_of(site, *model);
  EXPECT_EQ(maps.lit.lit(), 13u * 25u);
  // 1200 times the sum of sin 15k = cot 7.5 degrees.
  const double raw = 1200.0 / std::tan(7.5 * std::numbers::pi / 180.0);
  EXPECT_NEAR(maps.raw_energy.at(2, 2), raw, 1e-9);
  EXPECT_NEAR(maps.incoming.at(2, 2), 0.07 * raw, 1e-9);
  EXPECT_NEAR(maps.energy.at(2, 2), 0.75 * (1.0 + 0.1 * 0.25) * 0.07 * raw, 1e-9);
  EXPECT_EQ(maps.slope.at(2, 2), 0.0);
  EXPECT_EQ(maps.soil_depth.at(2, 2), 1.5);
  const double water = 2.5 * 0.38 - maps.energy.at(2, 2) / (2500.0 / 4184.0) / 1000.0;
  EXPECT_NEAR(maps.water.at(2, 2), water, 1e-12);
  const ChanceMaps chances = chance_maps(site, maps, apple_tree, *model, {});
  EXPECT_NEAR(chances.chance.at(2, 2), 0.184437, 1e-6);
  EXPECT_EQ(chances.depth.at(2, 2), 1.0);
}

TEST(SiteMaps, WithoutTheCosineThePolarSiteIsDry) {
  const auto model = corrected_site_model({.cosine = false});
  const SiteInput site = flat_site();
  const SiteMaps maps = maps_of(site, *model);
  EXPECT_EQ(maps.raw_energy.at(2, 2), 15600.0);
  EXPECT_NEAR(maps.incoming.at(2, 2), 1092.0, 1e-9);
  EXPECT_EQ(maps.water.at(2, 2), 0.0);
  EXPECT_EQ(chance_maps(site, maps, apple_tree, *model, {}).chance.at(2, 2), 0.0);
}

TEST(SiteMapsLaw, EveryPositionBringsWhatItsTimeBrings) {
  const SiteInput site = flat_site();
  const auto model = corrected_site_model();
  const SiteOptions hours{.suns = model->sun_path({})};
  SiteOptions halves = hours;
  halves.hours_each = 0.5;
  const auto engine = shadow_engine_named("exact_traversal").create();
  const SiteMaps whole = site_maps(site, hours, *model, *engine),
                 half = site_maps(site, halves, *model, *engine);
  EXPECT_EQ(half.raw_energy.at(2, 2), 0.5 * whole.raw_energy.at(2, 2));
  EXPECT_LT(half.energy.at(2, 2), whole.energy.at(2, 2));
}

// At the border fewer neighbours throw light over, each its share.
TEST(SiteMapsLaw, FlatGroundIsTheSameEverywhere) {
  const SiteMaps maps = maps_of(flat_site(), *corrected_site_model());
  for (const TerrainMap* map : {&maps.slope, &maps.raw_energy, &maps.energy, &maps.water})
    for (const double value : map->values) EXPECT_NEAR(value, map->values.front(), 1e-9);
}

TEST(SiteMapsLaw, NoMoreIsKeptThanComes) {
  SiteInput site = flat_site();
  const auto model = corrected_site_model();
  for (const double albedo : {0.0, 0.05, 0.5, 0.84, 1.0}) {
    site.soils[0].albedo = albedo;
    const SiteMaps maps = maps_of(site, *model);
    EXPECT_LE(maps.energy.at(2, 2), maps.incoming.at(2, 2)) << albedo;
  }
}

TEST(SiteMapsLaw, ThreadsChangeNothing) {
  SiteInput site = flat_site();
  for (std::size_t i = 0; i < 25; ++i)
    site.heights.heights()[i] = 13.0 * static_cast<double>(i % 7);
  const auto model = corrected_site_model();
  const SiteMaps one = maps_of(site, *model, 1), many = maps_of(site, *model, 4);
  EXPECT_EQ(one.lit, many.lit);
  EXPECT_EQ(one.energy, many.energy);
  EXPECT_EQ(one.water, many.water);
}

TEST(SiteMaps, VerticesWithoutDataHaveNoResult) {
  SiteInput site = flat_site();
  site.heights.at(1, 3) = HeightField::no_data;
  const auto model = corrected_site_model();
  const SiteMaps maps = maps_of(site, *model);
  const ChanceMaps chances = chance_maps(site, maps, apple_tree, *model, {});
  EXPECT_TRUE(std::isnan(maps.energy.at(1, 3)));
  EXPECT_TRUE(std::isnan(chances.chance.at(1, 3)));
  EXPECT_NEAR(chances.chance.at(2, 2), 0.184437, 1e-6);
  EXPECT_EQ(suitable_area(site.heights, chances.chance, 0.0).with_data, 24.0 * 256.0);
}

TEST(SiteMaps, OtherSoilsGrowNothing) {
  SiteInput site = flat_site();
  site.soils.push_back({"Stone", 80, 0.275, 0.1});
  site.soil_of[12] = 1;
  site.soil_of[13] = -1;
  const auto model = corrected_site_model();
  const ChanceMaps chances = chance_maps(site, maps_of(site, *model), apple_tree, *model, {});
  EXPECT_EQ(chances.chance.at(2, 2), 0.0);
  EXPECT_TRUE(std::isnan(chances.chance.at(3, 2)));
  EXPECT_GT(chances.chance.at(0, 0), 0.0);
}

TEST(SiteMaps, RefuseWhatDoesNotFit) {
  const auto complaint = [](const SiteInput& site) -> std::string {
    try {
      check_site(site);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(flat_site()), "");
  SiteInput site = flat_site();
  site.soil_of.pop_back();
  EXPECT_THAT(complaint(site), testing::HasSubstr("24 entries"));
  site = flat_site();
  site.soil_of[3] = 7;
  EXPECT_THAT(complaint(site), testing::HasSubstr("soil 7, for which there is no entry"));
  site = flat_site();
  site.biome.cloud_percent = 60.0;
  EXPECT_THAT(complaint(site), testing::HasSubstr("take 113 percent"));
  site = flat_site();
  site.neighbour_share = std::nan("");
  EXPECT_THAT(complaint(site), testing::HasSubstr("give 0 to 1"));
  site = flat_site();
  for (double& height : site.heights.heights()) height = HeightField::no_data;
  EXPECT_THAT(complaint(site), testing::HasSubstr("no vertex with data"));
}

}  // namespace
}  // namespace phytobench
