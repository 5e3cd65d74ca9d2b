// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/terrain_findings.hpp"
#include "cli/terrain_maps.hpp"
#include "reference/lesser2019_switches.hpp"

namespace phytobench::cli {

namespace {

constexpr double hectare_m2 = 1e4;

std::string name_of_site(const TerrainOptions& options) {
  return options.preset.empty() ? options.site : "preset " + options.preset;
}

/// "1 hour", "13 hours".
std::string counted(double number, std::string_view what) {
  return fmt::format("{:.4g} {}{}", number, what, number == 1.0 ? "" : "s");
}

/// "Dirt ([Lesser2019] listing 9.4)".
std::string with_source_in_brackets(const std::string& name, const std::string& source) {
  return fmt::format("{} ({})", name, source_or_yours(source));
}

std::string soil_names(const TerrainFindings& f) {
  std::vector<std::string> soils;
  for (const SoilFindings& soil : f.soils)
    soils.push_back(with_source_in_brackets(soil.name, soil.source));
  return fmt::format("soil{} {}\n", soils.size() == 1 ? "" : "s", fmt::join(soils, ", "));
}

std::string model_line(const Site& site, const TerrainFindings& f) {
  std::string text = fmt::format(
      "biome {}, {} of sun at {}, shadows by {}, {}\n",
      with_source_in_brackets(site.input.biome.name, f.biome_source), counted(f.hours, "hour"),
      counted(static_cast<double>(f.sun_positions), "position"), f.engine,
      f.as_printed.empty() ? "corrected" : "as printed: " + f.as_printed);
  if (f.as_printed == shown(lesser_switches("all")))
    text += "that is all that the program's listings have; " + left_out_of_all() +
            ", are left out unless they are named\n";
  return text;
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
  return text + model_line(site, f) + soil_names(f) + "\n";
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

std::string chance_table(const TerrainFindings& f) {
  std::string text =
      fmt::format("{:<40}{:>10}{:>10}{:>10}\n", "chance to grow", "mean", "least", "most");
  for (const SpeciesFindings& one : f.species)
    text += fmt::format("{:<40}{:>10.5g}{:>10.5g}{:>10.5g}\n", one.name, one.chance.mean,
                        one.chance.least, one.chance.most);
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
    text += fmt::format("{}: {}\n", one.name, source_or_yours(one.source));
  return "\n" + text;
}

/// Why there are fewer than were asked for, unless there are as many. Of darts for each hectare
/// those that come too close to another plant are always left out.
std::string shortfall(const TerrainFindings& f, const TerrainOptions& options) {
  const std::uint64_t placed = placed_plants_of(f);
  if (static_cast<double>(placed) >= f.wanted_plants) return "";
  if (options.plants.ends_with("/ha"))
    return fmt::format(" ({} of {:.15g} darts found room)", placed, f.wanted_plants);
  return fmt::format(" ({} of {:.15g}; no room for more)", placed, f.wanted_plants);
}

std::string placed_line(const TerrainFindings& f, const TerrainOptions& options) {
  const bool can_grow = std::any_of(f.species.begin(), f.species.end(),
                                    [](const auto& one) { return one.chance.most > 0.0; });
  if (placed_plants_of(f) == 0)
    return fmt::format("\nno plants: {}; neither placed.csv nor stand.toml is written\n",
                       can_grow ? "--plants " + options.plants + " is less than one on this map"
                                : "there is no chance to grow anywhere");
  std::vector<std::string> counts;
  for (const SpeciesFindings& one : f.species)
    counts.push_back(fmt::format("{} {}", one.plants, one.name));
  return fmt::format("\nplaced, seed {}: {}{}\n", options.seed, fmt::join(counts, ", "),
                     shortfall(f, options));
}

}  // namespace

std::string terrain_text(const Site& site, const TerrainFindings& f,
                         const TerrainOptions& options) {
  std::string text = terrain_heading(site, f, options) + range_table(f) + chance_table(f) +
                     species_table(f) + species_sources(f);
  if (!options.plants.empty()) text += placed_line(f, options);
  if (!f.files.empty())
    text += fmt::format("\nwrote to {}: {}\n", options.out, fmt::join(f.files, ", "));
  return text;
}

}  // namespace phytobench::cli
