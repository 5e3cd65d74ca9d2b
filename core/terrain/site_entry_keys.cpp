// SPDX-License-Identifier: MIT
// Keys of [[biome]], [[soil]] and [[species]].
#include "core/terrain/site_keys.hpp"

namespace phytobench {

namespace {

using Keys = std::vector<SiteKey>;
using Values = SiteFileValues;

constexpr std::string_view entry_name_allowed = "1 to 60 letters, digits, - and _";
constexpr NumberRange percent_range{.high = 100.0};
constexpr NumberRange share_range{.high = 1.0};
constexpr NumberRange litre_range{.high = 1e4};

SiteKey source_key(std::string_view name) {
  return {name,         "-",
          "\"\"",       "where the numbers come from",
          "phytobench", SiteText{"a text", [](Values& v) -> std::string& { return v.source; }}};
}

Keys biome_keys() {
  return {
      {"biome.name", "-", "\"MyZone\"", "how climate.biome calls it", "[Lesser2019] listing 9.3",
       SiteText{entry_name_allowed, [](Values& v) -> std::string& { return v.biome.name; }}, true},
      {"biome.absorption", "%", "45.0", "of the sun's energy, taken up by the air",
       "[Lesser2019] listing 9.3",
       SiteNumber{percent_range, [](Values& v, double x) { v.biome.absorption_percent = x; }},
       true},
      {"biome.diffusion", "%", "8.0", "the same, scattered", "[Lesser2019] listing 9.3",
       SiteNumber{percent_range, [](Values& v, double x) { v.biome.diffusion_percent = x; }}, true},
      {"biome.clouds", "%", "40.0",
       "the same, thrown back by clouds; the three together are at most 100",
       "[Lesser2019] listing 9.3",
       SiteNumber{percent_range, [](Values& v, double x) { v.biome.cloud_percent = x; }}, true},
      {"biome.rain", "l/m2 a day", "1.5", "mm of rain", "[Lesser2019] listing 9.3",
       SiteNumber{litre_range, [](Values& v, double x) { v.biome.rain = DailyWater(x); }}, true},
      {"biome.groundwater", "l/m2 a day", "1.0", "what comes from below",
       "[Lesser2019] listing 9.3, erratum E32",
       SiteNumber{litre_range, [](Values& v, double x) { v.biome.groundwater = DailyWater(x); }},
       true},
      source_key("biome.source"),
  };
}

Keys soil_keys() {
  return {
      {"soil.name", "-", "\"MySoil\"", "how other keys call it", "[Lesser2019] listing 9.4",
       SiteText{entry_name_allowed, [](Values& v) -> std::string& { return v.soil.name; }}, true},
      {"soil.id", "-", "90", "its number on a map of soils", "[Lesser2019] listing 9.4",
       SiteNumber{{.high = 32767.0, .whole = true},
                  [](Values& v, double x) { v.soil.id = static_cast<int>(x); }},
       true},
      {"soil.albedo", "share", "0.25", "of the light, thrown back", "[Lesser2019] listing 9.4",
       SiteNumber{share_range, [](Values& v, double x) { v.soil.albedo = x; }}, true},
      {"soil.water_absorption", "share", "0.38", "of the water, taken up",
       "[Lesser2019] listing 9.4",
       SiteNumber{share_range, [](Values& v, double x) { v.soil.water_absorption = x; }}, true},
      source_key("soil.source"),
  };
}

Keys plant_keys() {
  return {
      {"species.name", "-", "\"MyPlant\"", "how results call it", "[Lesser2019] listing 9.6",
       SiteText{entry_name_allowed, [](Values& v) -> std::string& { return v.species.name; }},
       true},
      {"species.energy_demand", "kcal/m2 a day", "2000.0", "light that suits it best; 0: any",
       "[Lesser2019] listing 9.6",
       SiteNumber{{.high = 1e6},
                  [](Values& v, double x) { v.species.energy_demand = DailyEnergy(x); }},
       true},
      {"species.water_demand", "l/m2 a day", "0.7", "water that suits it best; 0: any",
       "[Lesser2019] listing 9.6, erratum E32",
       SiteNumber{litre_range, [](Values& v, double x) { v.species.water_demand = DailyWater(x); }},
       true},
      {"species.soil", "-", "\"Dirt\"", "the only soil that it grows on; \"\": any",
       "[Lesser2019] listing 9.6",
       SiteText{"a name of a soil", [](Values& v) -> std::string& { return v.species.soil; }},
       true},
      {"species.soil_depth", "cm", "80.0", "that its roots need; 0: none",
       "[Lesser2019] listing 9.6",
       SiteNumber{{.high = 1e4},
                  [](Values& v, double x) { v.species.soil_depth = centimetres(x); }},
       true},
      {"species.spacing", "m", "1.0", "between two of them, at least, for --plants", "phytobench",
       SiteNumber{{.high = 1e4}, [](Values& v, double x) { v.species.spacing = x; }}},
      {"species.start_radius", "m", "0.05", "of a stem, for --plants", "phytobench",
       SiteNumber{{.low = 1e-4, .high = 0.5},
                  [](Values& v, double x) { v.species.start_radius = x; }}},
      source_key("species.source"),
  };
}

}  // namespace

std::vector<SiteKey> site_entry_keys() {
  Keys keys = biome_keys();
  for (const Keys& more : {soil_keys(), plant_keys()})
    keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

}  // namespace phytobench
