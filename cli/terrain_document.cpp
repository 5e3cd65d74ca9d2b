// SPDX-License-Identifier: MIT
// The document of phytobench/terrain-1, which is also summary.json.
#include <cmath>

#include <nlohmann/json.hpp>

#include "build_information.hpp"
#include "cli/option_values.hpp"
#include "cli/terrain_findings.hpp"
#include "cli/terrain_plants.hpp"
#include "cli/terrain_settings.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

/// JSON knows neither NaN nor infinity.
ordered_json terrain_number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json terrain_text_or_null(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json range_json(const MapRange& range) {
  return {{"mean", terrain_number(range.mean)},
          {"least", terrain_number(range.least)},
          {"most", terrain_number(range.most)},
          {"cells", range.cells}};
}

ordered_json species_json(const SpeciesFindings& species) {
  ordered_json areas = ordered_json::array();
  for (std::size_t i = 0; i < suitable_from.size(); ++i)
    areas.push_back({{"least_chance", suitable_from[i]}, {"m2", species.suitable_m2[i]}});
  ordered_json limits = ordered_json::object();
  for (std::size_t i = 0; i < factor_names.size(); ++i)
    limits[factor_names[i]] = species.limited_m2[i];
  return {{"name", species.name},    {"source", terrain_text_or_null(species.source)},
          {"suitable", areas},       {"with_data_m2", species.with_data_m2},
          {"limited_by_m2", limits}, {"chance", range_json(species.chance)},
          {"plants", species.plants}};
}

ordered_json place_json(const std::optional<GeoReference>& place) {
  if (!place) return nullptr;
  return {{"west", place->west},
          {"north", place->north},
          {"column_step", place->column_step},
          {"row_step", place->row_step},
          {"projection", terrain_text_or_null(place->projection)}};
}

ordered_json terrain_ground_json(const Site& site, const TerrainFindings& findings) {
  const HeightField& heights = site.input.heights;
  return {{"from", site.heights},
          {"columns", heights.columns()},
          {"rows", heights.rows()},
          {"cell_m", {heights.cell_width(), heights.cell_depth()}},
          {"cells_with_data", findings.height.cells},
          {"soilless_share", site.soilless_share},
          {"place", place_json(site.place)}};
}

ordered_json soils_json(const std::vector<SoilFindings>& soils) {
  ordered_json json = ordered_json::array();
  for (const SoilFindings& soil : soils)
    json.push_back(
        {{"name", soil.name}, {"source", terrain_text_or_null(soil.source)}, {"m2", soil.m2}});
  return json;
}

/// null without --plants.
ordered_json placed_json(const TerrainFindings& findings, const TerrainOptions& options) {
  if (options.plants.empty()) return nullptr;
  return {{"asked", options.plants},
          {"per_hectare", plant_sampling_from(options).is_per_hectare},
          {"wanted", findings.wanted_plants},
          {"placed", placed_plants_of(findings)}};
}

}  // namespace

std::string terrain_json(const TerrainDocument& document) {
  const auto& [description, site, f, options] = document;
  ordered_json json{
      {"schema", "phytobench/terrain-1"},
      {"program", {{"version", build_information::version}, {"commit", build_information::commit}}},
      {"site", terrain_text_or_null(options.site)},
      {"preset", terrain_text_or_null(options.preset)},
      {"ground", terrain_ground_json(site, f)},
      {"biome", site.input.biome.name},
      {"biome_source", terrain_text_or_null(f.biome_source)},
      {"soils", soils_json(f.soils)},
      {"hours", f.hours},
      {"sun_positions", f.sun_positions},
      {"engine", f.engine},
      {"as_printed", terrain_text_or_null(f.as_printed)},
      {"height_m", range_json(f.height)},
      {"slope_degrees", range_json(f.slope)},
      {"lit_hours", range_json(f.lit_hours)},
      {"raw_energy", range_json(f.raw_energy)},
      {"energy", range_json(f.energy)},
      {"soil_depth_cm", range_json(f.soil_depth)},
      {"water", range_json(f.water)},
      {"species", ordered_json::array()}};
  for (const SpeciesFindings& one : f.species) json["species"].push_back(species_json(one));
  json["seed"] = options.plants.empty() ? ordered_json(nullptr) : ordered_json(options.seed);
  json["plants"] = placed_json(f, options);
  json["settings"] = terrain_settings(description, site, options);
  json["files"] = f.files;
  json["older_files"] = f.older_files;
  return json_text(json) + "\n";
}

}  // namespace phytobench::cli
