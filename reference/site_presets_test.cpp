// SPDX-License-Identifier: MIT
#include "reference/site_presets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/site.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(SitePresets, CanBeReadAndSayWhatTheyAre) {
  EXPECT_GE(site_presets().size(), 3u);
  for (const SitePreset& preset : site_presets()) {
    const SiteDescription site = read_site_file(preset.file, site_entry_file);
    EXPECT_NO_THROW(load_site(site)) << preset.name;
    EXPECT_GT(preset.summary.size(), 20u) << preset.name;
  }
}

TEST(SitePresets, TheExampleCanBeLoaded) {
  const SiteDescription site = parse_site(example_site_file(), "example.toml", site_entry_file);
  EXPECT_NO_THROW(load_site(site));
}

template <class Entry>
const SiteEntry<Entry>& site_entry_of(const std::vector<SiteEntry<Entry>>& entries,
                                      const std::string& name) {
  for (const SiteEntry<Entry>& entry : entries)
    if (entry.entry.name == name) return entry;
  throw InputError("no " + name);
}

/// [Lesser2019] listings 9.3 to 9.6, fig. 10.2.
TEST(SitePresets, HoldTheValuesOfTheThesis) {
  const SiteDescription site = read_site_file(site_preset_file("worked-example"), site_entry_file);
  const Biome& polar = site_entry_of(site.biomes, "PolarZone").entry;
  EXPECT_EQ(polar.absorption_percent, 45.0);
  EXPECT_EQ(polar.diffusion_percent, 8.0);
  EXPECT_EQ(polar.cloud_percent, 40.0);
  EXPECT_EQ(polar.rain.value(), 1.5);
  EXPECT_EQ(polar.groundwater.value(), 1.0);
  const Soil& dirt = site_entry_of(site.soils, "Dirt").entry;
  EXPECT_EQ(dirt.id, 40);
  EXPECT_EQ(dirt.albedo, 0.25);
  EXPECT_EQ(dirt.water_absorption, 0.38);
  struct Plant {
    const char* name;
    double energy, water;
    const char* soil;
    double depth_cm;
  };
  for (const Plant& plant : {Plant{"Appletree", 2000, 0.7, "Dirt", 80},
                             {"Shrub", 1200, 0.3, "Dirt", 20},
                             {"Moss", 1000, 0.3, "Stone", 1}}) {
    const SitePlant& found = site_entry_of(site.species, plant.name).entry;
    EXPECT_EQ(found.energy_demand.value(), plant.energy) << plant.name;
    EXPECT_EQ(found.water_demand.value(), plant.water) << plant.name;
    EXPECT_EQ(found.soil, plant.soil);
    EXPECT_DOUBLE_EQ(in_centimetres(found.soil_depth), plant.depth_cm) << plant.name;
    EXPECT_THAT(site_entry_of(site.species, plant.name).source, HasSubstr("[Lesser2019]"));
  }
}

/// Nobody is to take them for the thesis' own.
TEST(SitePresets, WhatIsAssumedSaysSo) {
  const SiteDescription site = read_site_file(site_preset_file("worked-example"), site_entry_file);
  for (const char* name : {"TemperateZone", "SubtropicalZone"})
    EXPECT_THAT(site_entry_of(site.biomes, name).source, HasSubstr("assumed"));
  for (const char* name : {"Stone", "Clay", "Loam", "Sand"})
    EXPECT_THAT(site_entry_of(site.soils, name).source, HasSubstr("assumed"));
  for (const char* name : {"Fir", "Beech", "Cactus"})
    EXPECT_THAT(site_entry_of(site.species, name).source, HasSubstr("assumed"));
  std::size_t with_assumed_biome = 0;
  for (const SitePreset& preset : site_presets()) {
    const SiteDescription its = read_site_file(preset.file, site_entry_file);
    if (site_entry_of(its.biomes, its.biome).source != "assumed") continue;
    ++with_assumed_biome;
    EXPECT_THAT(preset.summary, AllOf(HasSubstr("biome"), HasSubstr("assumed"))) << preset.name;
  }
  EXPECT_EQ(with_assumed_biome, 2u);
}

TEST(SitePresets, AnUnknownNameGetsTheClosestOne) {
  EXPECT_EQ(site_preset_file("fractal").filename(), "fractal.toml");
  for (const auto& [call, part] :
       {std::pair<std::filesystem::path (*)(const std::string&), const char*>{
            site_preset_file, "see phytobench list sites"},
        {site_entry_file, "phytobench list site-entries"}})
    try {
      call("lesser2018");
      ADD_FAILURE() << part;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

}  // namespace
}  // namespace phytobench
