// SPDX-License-Identifier: MIT
#include "cli/terrain_maps.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"
#include "core/terrain/files/gdal_raster.hpp"
#include "core/terrain/files/map_files.hpp"

namespace phytobench::cli {

namespace {

constexpr int most_map_pixels = 8192, most_svg_pixels = 1024;  // of a side

const std::vector<std::string>& known_map_formats() {
  static const std::vector<std::string> formats{"png", "svg", "tif", "asc", "csv"};
  return formats;
}

TerrainMap heights_map(const HeightField& heights) {
  return {heights.columns(), heights.rows(), {heights.heights().begin(), heights.heights().end()}};
}

/// Ids of soils; NaN without one.
TerrainMap soil_ids(const SiteInput& input) {
  TerrainMap map = heights_map(input.heights);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const int soil = std::isnan(map.values[i]) ? -1 : input.soil_of[i];
    map.values[i] =
        soil < 0 ? HeightField::no_data : input.soils[static_cast<std::size_t>(soil)].id;
  }
  return map;
}

/// What cells without a number lack: "no data, no soil"; empty if there is a number in all.
std::string what_is_missing(const SiteInput& input, const TerrainMap& numbers) {
  bool data = false, soil = false, number = false;
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    if (!std::isnan(numbers.values[i])) continue;
    const bool has_data = !std::isnan(input.heights.heights()[i]), has_soil = input.soil_of[i] >= 0;
    data |= !has_data;
    soil |= has_data && !has_soil;
    number |= has_data && has_soil;  // a division by nothing that is left as printed
  }
  std::vector<std::string_view> missing;
  if (data) missing.emplace_back("no data");
  if (soil) missing.emplace_back("no soil");
  if (number) missing.emplace_back("no number");
  return fmt::format("{}", fmt::join(missing, ", "));
}

MapSheet new_sheet(const Site& site, std::string name, std::string title, std::string unit,
                   const MapPalette& palette, TerrainMap numbers) {
  const HeightField& heights = site.input.heights;
  MapSheet result{.name = std::move(name), .legend = {}, .numbers = std::move(numbers)};
  result.legend = {.title = std::move(title),
                   .unit = std::move(unit),
                   .bar = {&palette, scale_of(result.numbers.values)},
                   .entries = {},
                   .width_m = heights.columns() * heights.cell_width(),
                   .depth_m = heights.rows() * heights.cell_depth(),
                   .without = what_is_missing(site.input, result.numbers)};
  return result;
}

/// Pictures in colours of kinds, or of directions, have entries instead of a bar.
MapSheet soil_sheet(const Site& site) {
  MapSheet result = new_sheet(site, "soil", "Soil", "", height_palette(), soil_ids(site.input));
  result.legend.bar.palette = nullptr;
  std::vector<bool> is_there(site.input.soils.size(), false);
  for (const std::int16_t soil : site.input.soil_of)
    if (soil >= 0) is_there[static_cast<std::size_t>(soil)] = true;
  for (std::size_t i = 0; i < is_there.size(); ++i)
    if (is_there[i]) result.legend.entries.push_back({kind_colour(i), site.input.soils[i].name});
  return result;
}

MapSheet normal_sheet(const Site& site) {
  MapSheet result = new_sheet(site, "normals", "Surface normals", "", height_palette(), {});
  result.legend.bar.palette = nullptr;
  result.legend.without = what_is_missing(site.input, heights_map(site.input.heights));
  const double half = std::sqrt(0.5);
  result.legend.entries = {{normal_colour(0.0, 0.0, 1.0), "level"},
                           {normal_colour(0.0, -half, half), "45 degrees to the north"},
                           {normal_colour(half, 0.0, half), "to the east"},
                           {normal_colour(0.0, half, half), "to the south"},
                           {normal_colour(-half, 0.0, half), "to the west"}};
  return result;
}

Image sheet_picture(const Site& site, const MapSheet& sheet, int most) {
  const HeightField& heights = site.input.heights;
  const int every = thinning(heights.columns(), heights.rows(), most);
  if (sheet.legend.bar.palette != nullptr)
    return map_image(sheet.numbers, sheet.legend.bar.scale, *sheet.legend.bar.palette, every);
  if (!sheet.numbers.values.empty()) {
    std::vector<std::int16_t> kinds = site.input.soil_of;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (std::isnan(sheet.numbers.values[i])) kinds[i] = -1;
    return kind_image(heights.columns(), heights.rows(), kinds, every);
  }
  return normal_image(
      heights, surface_gradients(heights, site.options.surface, site.options.threads), every);
}

}  // namespace

TerrainMap lit_hours_map(const Site& site, const LitMaps& lit) {
  TerrainMap map = heights_map(site.input.heights);
  const std::vector<std::uint16_t> positions = lit_positions(lit);
  for (std::size_t i = 0; i < map.values.size(); ++i)
    if (!std::isnan(map.values[i])) map.values[i] = site.options.hours_each * positions[i];
  return map;
}

TerrainMap in_centimetres(const TerrainMap& metres) {
  TerrainMap map = metres;
  for (double& value : map.values) value *= 100.0;
  return map;
}

std::vector<MapSheet> site_sheets(const Site& site, const SiteMaps& maps) {
  const HeightField& heights = site.input.heights;
  std::vector<MapSheet> sheets;
  sheets.push_back(
      new_sheet(site, "heights", "Heights", "m", height_palette(), heights_map(heights)));
  sheets.push_back(soil_sheet(site));
  sheets.push_back(new_sheet(site, "lit-hours", "Hours in the light", "h a day",
                             insolation_palette(), lit_hours_map(site, maps.lit)));
  sheets.push_back(new_sheet(site, "insolation", "Light kept by the ground", "kcal/m2 a day",
                             insolation_palette(), maps.energy));
  sheets.push_back(normal_sheet(site));
  sheets.push_back(new_sheet(site, "slope", "Slope", "degrees", height_palette(), maps.slope));
  sheets.push_back(new_sheet(site, "soil-depth", "Depth of the soil", "cm", soil_depth_palette(),
                             in_centimetres(maps.soil_depth)));
  sheets.push_back(new_sheet(site, "water", "Water left for plants", "l/m2 a day",
                             hydrology_palette(), maps.water));
  return sheets;
}

std::string source_or_yours(const std::string& source) {
  return source.empty() ? "yours" : in_one_line(source, 200);
}

MapSheet chance_sheet(const Site& site, const SiteEntry<SitePlant>& species, TerrainMap chance,
                      const std::string& biome_source) {
  const std::string& name = species.entry.name;
  MapSheet result = new_sheet(site, "chance-" + name, "Chance to grow: " + name, "0 to 1",
                              probability_palette(), std::move(chance));
  result.legend.bar.scale = {0.0, 1.0};
  result.legend.note =
      fmt::format("{}: {}; {}: {}", name, in_one_line(source_or_yours(species.source)),
                  site.input.biome.name, in_one_line(source_or_yours(biome_source)));
  return result;
}

void check_map_formats(const std::vector<std::string>& formats) {
  for (const std::string& format : formats) {
    const auto& known = known_map_formats();
    if (format == "none" && formats.size() == 1) continue;
    if (std::find(known.begin(), known.end(), format) == known.end())
      throw InputError("--maps " + format + ": unknown format" + did_you_mean(format, known) +
                       "; give some of png, svg, tif, asc, csv, or none alone");
    if (format == "tif") raster_module("--maps tif");
  }
}

std::vector<FileContent> sheet_files(const Site& site, const MapSheet& sheet,
                                     const std::vector<std::string>& formats) {
  std::vector<FileContent> files;
  for (const std::string& format : formats) {
    const std::string name = sheet.name + "." + format;
    if (format == "none") continue;
    if (format == "png") {
      files.push_back({name, to_png(sheet_picture(site, sheet, most_map_pixels))});
    } else if (format == "svg") {
      files.push_back({name, map_svg(sheet_picture(site, sheet, most_svg_pixels), sheet.legend)});
    } else if (!sheet.numbers.values.empty()) {
      const MapView view = map_view(site.input.heights, sheet.numbers.values, site.place);
      for (FileContent& file : map_files(name, view)) files.push_back(std::move(file));
    }
  }
  return files;
}

}  // namespace phytobench::cli
