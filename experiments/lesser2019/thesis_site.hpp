// SPDX-License-Identifier: MIT
// The biome, soil and species whose numbers [Lesser2019] prints.
#pragma once

#include <string>

#include "core/terrain/site_parameters.hpp"
#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::lesser2019 {

inline TomlTable thesis_parameters() {
  return TomlTable::read(paper_folder("lesser2019") / "parameters.toml");
}

/// An entry of one of its lists, by name.
inline TomlTable thesis_entry(const std::string& list, const std::string& name) {
  const TomlTable parameters = thesis_parameters();
  for (const TomlTable& entry : parameters.tables(list))
    if (entry.text("name") == name) return entry;
  parameters.fail("there is no " + list + " '" + name + "'");
}

/// Listing 9.3.
inline const Biome& polar_zone() {
  static const Biome biome = [] {
    const TomlTable entry = thesis_entry("biome", "PolarZone");
    return Biome{.name = "PolarZone",
                 .absorption_percent = entry.number("absorption_percent"),
                 .diffusion_percent = entry.number("diffusion_percent"),
                 .cloud_percent = entry.number("cloud_percent"),
                 .rain = DailyWater(entry.number("rain_l_per_day")),
                 .groundwater = DailyWater(entry.number("groundwater_l"))};
  }();
  return biome;
}

/// Listing 9.4.
inline const Soil& thesis_dirt() {
  static const Soil soil = [] {
    const TomlTable entry = thesis_entry("soil", "Dirt");
    return Soil{.name = "Dirt",
                .id = static_cast<int>(entry.number("id")),
                .albedo = entry.number("albedo"),
                .water_absorption = entry.number("water_absorption")};
  }();
  return soil;
}

inline PlantSpecies species_from(const TomlTable& entry) {
  return {.name = entry.text("name"),
          .energy_demand = DailyEnergy(entry.number("energy_kcal_per_day")),
          .water_demand = DailyWater(entry.number("water_l_per_day")),
          .soil = entry.text("soil"),
          .soil_depth = centimetres(entry.number("soil_depth_cm"))};
}

/// Figure 10.2.
inline const PlantSpecies& appletree() {
  static const PlantSpecies species = species_from(thesis_entry("species", "Appletree"));
  return species;
}
inline const PlantSpecies& shrub() {
  static const PlantSpecies species = species_from(thesis_entry("species", "Shrub"));
  return species;
}
inline const PlantSpecies& moss() {
  static const PlantSpecies species = species_from(thesis_entry("species", "Moss"));
  return species;
}

}  // namespace phytobench::experiments::lesser2019
