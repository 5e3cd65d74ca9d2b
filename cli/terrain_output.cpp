// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/option_values.hpp"
#include "cli/terrain_findings.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

constexpr double hectare_m2 = 1e4;

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

ordered_json terrain_ground_json(const Site& site, const TerrainFindings& findings) {
  const HeightField& heights = site.input.heights;
  return {{"from", site.heights},
          {"columns", heights.columns()},
          {"rows", heights.rows()},
          {"cell_m", {heights.cell_width(), heights.cell_depth()}},
          {"cells_with_data", findings.height.cells},
          {"soilless_share", site.soilless_share}};
}

std::string name_of_site(const TerrainOptions& options) {
  return options.preset.empty() ? options.site : "preset " + options.preset;
}

/// " (assumed)".
std::string in_brackets(const std::string& source) {
  return source.empty() ? "" : " (" + source + ")";
}

std::string terrain_heading(const Site& site, const TerrainFindings& f,
                            const TerrainOptions& options) {
  const HeightField& heights = site.input.heights;
  std::string text =
      fmt::format("{}: {} by {} cells of {:.4g} m by {:.4g} m, {:.4g} to {:.4g} m high ({})\n",
                  name_of_site(options), heights.columns(), heights.rows(), heights.cell_width(),
                  heights.cell_depth(), f.height.least, f.height.most, site.heights);
  if (f.height.cells < heights.size())
    text += fmt::format(
        "no data in {:.3g} % of the cells\n",
        100.0 * (1.0 - static_cast<double>(f.height.cells) / static_cast<double>(heights.size())));
  if (site.soilless_share > 0.0)
    text += fmt::format("no soil in {:.3g} % of the rest\n", 100.0 * site.soilless_share);
  text += fmt::format("biome {}{}, {:.4g} hours of sun at {} positions, shadows by {}, {}\n\n",
                      site.input.biome.name, in_brackets(f.biome_source), f.hours, f.sun_positions,
                      f.engine, f.as_printed.empty() ? "corrected" : "as printed: " + f.as_printed);
  return text;
}

std::string range_table(const TerrainFindings& f) {
  const std::pair<const char*, const MapRange*> rows[] = {
      {"slope, degrees", &f.slope},
      {"hours in the light", &f.lit_hours},
      {"light above the air, kcal/m2 a day", &f.raw_energy},
      {"light kept by the ground, kcal/m2 a day", &f.energy},
      {"soil depth, cm", &f.soil_depth},
      {"water left, l/m2 a day", &f.water}};
  std::string text = fmt::format("{:<40}{:>10}{:>10}{:>10}\n", "", "mean", "least", "most");
  for (const auto& [name, range] : rows)
    text += fmt::format("{:<40}{:>10.4g}{:>10.4g}{:>10.4g}\n", name, range->mean, range->least,
                        range->most);
  return text + "\n";
}

/// The factor that keeps most ground from being better.
std::string worst_factor(const SpeciesFindings& species) {
  const auto most = std::max_element(species.limited_m2.begin(), species.limited_m2.end());
  if (!(*most > 0.0)) return "nothing";
  return fmt::format("{} ({:.0f} %)",
                     factor_names[static_cast<std::size_t>(most - species.limited_m2.begin())],
                     100.0 * *most / species.with_data_m2);
}

std::string species_table(const TerrainFindings& f) {
  std::size_t width = std::string("hectares where the chance is").size();
  for (const SpeciesFindings& one : f.species) width = std::max(width, one.name.size());
  std::string text =
      fmt::format("{:<{}}{:>12}{:>12}{:>12}{:>12}  {}\n", "hectares where the chance is", width,
                  "> 0", ">= 0.25", ">= 0.5", "known", "held back most by");
  for (const SpeciesFindings& one : f.species) {
    text += fmt::format("{:<{}}", one.name, width);
    for (const double area : one.suitable_m2) text += fmt::format("{:>12.1f}", area / hectare_m2);
    text += fmt::format("{:>12.1f}  {}\n", one.with_data_m2 / hectare_m2, worst_factor(one));
  }
  return text;
}

std::string species_sources(const TerrainFindings& f) {
  std::string text;
  for (const SpeciesFindings& one : f.species)
    if (!one.source.empty()) text += fmt::format("{}: {}\n", one.name, one.source);
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string terrain_json(const Site& site, const TerrainFindings& f,
                         const TerrainOptions& options) {
  ordered_json json{{"schema", "phytobench/terrain-1"},
                    {"site", terrain_text_or_null(options.site)},
                    {"preset", terrain_text_or_null(options.preset)},
                    {"ground", terrain_ground_json(site, f)},
                    {"biome", site.input.biome.name},
                    {"biome_source", terrain_text_or_null(f.biome_source)},
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
  json["files"] = f.files;
  json["older_files"] = f.older_files;
  return json_text(json) + "\n";
}

std::string terrain_text(const Site& site, const TerrainFindings& f,
                         const TerrainOptions& options) {
  std::string text =
      terrain_heading(site, f, options) + range_table(f) + species_table(f) + species_sources(f);
  if (!options.plants.empty()) {
    std::vector<std::string> counts;
    for (const SpeciesFindings& one : f.species)
      counts.push_back(fmt::format("{} {}", one.plants, one.name));
    text += fmt::format("\nplaced, seed {}: {}\n", options.seed, fmt::join(counts, ", "));
  }
  if (!f.files.empty())
    text += fmt::format("\nwrote to {}: {}\n", options.out, fmt::join(f.files, ", "));
  return text;
}

}  // namespace phytobench::cli
