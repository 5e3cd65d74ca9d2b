// SPDX-License-Identifier: MIT
#include "reference/lesser2019_site_model.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/terrain/site_maps.hpp"

namespace phytobench {
namespace {

/// Flat dirt in the polar zone.
SiteInput polar_flat(int side = 5) {
  SiteInput input;
  input.heights = HeightField(side, side, 16.0, 16.0);
  input.soils = {{"Dirt", 40, 0.25, 0.38}};
  input.soil_of.assign(input.heights.size(), 0);
  input.biome = {"PolarZone", 45.0, 8.0, 40.0, DailyWater(1.5), DailyWater(1.0)};
  return input;
}

PlantSpecies apple_tree() {
  return {"Appletree", DailyEnergy(2000.0), DailyWater(0.7), "Dirt", centimetres(80.0)};
}

/// The chance in the middle of the flat map.
struct Middle {
  double energy, water, chance;
};
Middle middle_of(const std::string& printed, const PlantSpecies& species = apple_tree()) {
  const LesserSwitches switches = lesser_switches(printed);
  const auto model = printed_site_model(switches);
  const SiteInput input = polar_flat();
  const SiteOptions options{.suns = model->sun_path({})};
  const SiteMaps maps = site_maps(input, options, *model, *lesser_shadows(switches));
  return {maps.energy.at(2, 2), maps.water.at(2, 2),
          chance_maps(input, maps, species, *model, options).chance.at(2, 2)};
}

TEST(LesserSiteModelOracle, TheWorkedExampleAsPrinted) {
  const Middle all = middle_of("all");
  EXPECT_NEAR(all.energy, 900.9, 1e-9);
  EXPECT_NEAR(all.water, 0.463514, 1e-9);
  EXPECT_NEAR(all.chance, 0.45045, 1e-12);
  EXPECT_NEAR(
      middle_of("all", {"Shrub", DailyEnergy(1200.0), DailyWater(0.3), "Dirt", centimetres(20.0)})
          .chance,
      1 - (0.463514 / 0.3 - 1), 1e-9);
}

TEST(LesserSiteModelOracle, TheWorkedExampleCorrected) {
  EXPECT_NEAR(middle_of("none").energy, 490.495822, 1e-6);
  EXPECT_NEAR(middle_of("none").water, 0.129106, 1e-6);
  EXPECT_NEAR(middle_of("none").chance, 0.184437, 1e-6);
}

/// With all else printed: what one correction does by itself.
TEST(LesserSiteModelOracle, TheWorkedExampleWithOneCorrection) {
  const std::string printed = "E03,E04,E08,E09,E10,E12,E18,E19";
  EXPECT_NEAR(middle_of(printed + ",E01,E07,E13,E16").chance, 0.45045, 1e-12);
  EXPECT_NEAR(middle_of(printed + ",E07,E13,E16").water, 0.4117, 1e-4) << "without E01";
  EXPECT_NEAR(middle_of(printed + ",E01,E07,E13").chance, 0, 1e-12) << "without E16";
  EXPECT_NEAR(middle_of(printed + ",E07,E13").chance, 0, 1e-12) << "without both";
  EXPECT_NEAR(middle_of(printed + ",E01,E07,E16").chance, 0.4197375, 1e-12) << "without E13";
  EXPECT_NEAR(middle_of(printed + ",E13").chance, 0.098630, 1e-6) << "without E01, E07, E16";
  EXPECT_NEAR(middle_of("all,E21").chance, 0.125, 1e-12);
  EXPECT_NEAR(middle_of("E21").chance, 0.125, 1e-12);
}

TEST(LesserSiteModelOracle, WithNothingPrintedItIsTheCorrectedOne) {
  const auto printed = printed_site_model(lesser_switches("none"));
  const auto corrected = corrected_site_model();
  const HourlyPath path{.hours = 12};
  EXPECT_EQ(printed->sun_path(path), corrected->sun_path(path));
  EXPECT_EQ(printed->hourly_energy({0.3, -0.2}, {0.6, 0.0, 0.8}),
            corrected->hourly_energy({0.3, -0.2}, {0.6, 0.0, 0.8}));
  EXPECT_EQ(printed->soil_depth(33.0, Length(1.5)), corrected->soil_depth(33.0, Length(1.5)));
  EXPECT_EQ(printed->chance(0.3, 0.7, Tolerance::triangle), 0.3 / 0.7);
}

TEST(LesserSiteModelOracle, PathsOfTheSun) {
  const auto last = [](const std::string& text, const HourlyPath& path) {
    return printed_site_model(lesser_switches(text))->sun_path(path).back();
  };
  EXPECT_NEAR(last("E03", {.hours = 12}).up, std::sin(15 * 0.017453292519943295), 1e-12);
  EXPECT_NEAR(last("E04", {.hours = 12}).up, 0.0, 1e-12);
  EXPECT_NEAR(last("E04", {.hours = 2, .start_azimuth = 20.0}).east,
              std::cos(160 * 0.017453292519943295), 1e-12);
  EXPECT_NEAR(last("E03", {.hours = 2, .start_azimuth = 20.0}).up, 1.0, 1e-12);
  EXPECT_NEAR(printed_site_model(lesser_switches("E02"))->sun_path({})[6].up,
              std::sin(83.07692307692308 * 0.017453292519943295), 1e-12);
  // In odd hours nothing else than the rounding happens.
  const auto all = printed_site_model(lesser_switches("all"))->sun_path({});
  EXPECT_EQ(all[1], (SunDirection{0.933, 0.25, 0.2588}));
  EXPECT_EQ(all[12], (SunDirection{-1.0, 0.0, 0.0}));
}

TEST(LesserSiteModelOracle, EachStageByItself) {
  const auto with = [](const char* text) { return printed_site_model(lesser_switches(text)); };
  EXPECT_EQ(with("E07")->hourly_energy({}, {1.0, 0.0, 0.0}).value(), 1200.0);
  const Biome polar = polar_flat().biome;
  EXPECT_NEAR(with("E14")->through_air(DailyEnergy(15600.0), polar).value() * 0.75, 11591.19, 1e-9);
  Biome taken = polar;
  taken.diffusion_percent = 18.0;
  EXPECT_NEAR(with("E19")->through_air(DailyEnergy(15600.0), taken).value(), -468.0, 1e-9);
  EXPECT_NEAR(in_centimetres(with("E15")->soil_depth(0.0, Length(1.5))), 148.33333333333333, 1e-9);
  EXPECT_NEAR(in_centimetres(with("E22,E23")->soil_depth(0.0, Length(1.5))), 18.928, 1e-9);
  EXPECT_NEAR(in_centimetres(with("E23")->soil_depth(0.0, Length(1.5))), 18.928, 1e-9);
  EXPECT_NEAR(in_centimetres(with("E22")->soil_depth(0.0, Length(1.5))), 150.0, 1e-9);
  EXPECT_EQ(with("E22")->chance(1.001, 2.0, Tolerance::triangle), 0.5);
  EXPECT_TRUE(std::isnan(with("E18")->chance(0.0, 0.0, Tolerance::triangle)));
  EXPECT_EQ(with("E18")->chance(1.0, 0.0, Tolerance::triangle), 0.0);
  EXPECT_EQ(with("E18")->chance(1.0, 0.0, Tolerance::saturating), 1.0);
  EXPECT_EQ(with("none")->chance(1.0, 0.0, Tolerance::triangle), 1.0);
}

TEST(LesserSiteModelOracle, ReflectionAtTheBorder) {
  const TerrainMap light{5, 5, std::vector<double>(25, 1092.0)};
  const TerrainMap albedo{5, 5, std::vector<double>(25, 0.25)};
  const auto edge = [&](const char* text) {
    return printed_site_model(lesser_switches(text))->absorbed(light, albedo, 0.1, 1).at(0, 2);
  };
  EXPECT_NEAR(edge("E12,E13"), 870.1875, 1e-9);
  EXPECT_NEAR(edge("E13"), 900.9, 1e-9);
  EXPECT_NEAR(edge("E12"), 819 + 0.75 * 0.1 * 273 * 5 / 8, 1e-9);
  EXPECT_NEAR(edge("none"), 839.475, 1e-9);
}

}  // namespace
}  // namespace phytobench
