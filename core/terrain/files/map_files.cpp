// SPDX-License-Identifier: MIT
#include "core/terrain/files/map_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/picture/grey_image.hpp"
#include "core/terrain/files/gdal_raster.hpp"

namespace phytobench {

namespace {

void expect_all_values(const MapView& map) {
  PHYTOBENCH_EXPECT(map.columns > 0 && map.rows > 0);
  PHYTOBENCH_EXPECT(map.values.size() ==
                    static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows));
}

/// Metres from the north-west where nothing is known of the place.
GeoReference place_or_metres(const MapView& map) {
  if (map.place) return *map.place;
  return {0.0, map.cell_depth * map.rows, map.cell_width, -map.cell_depth, {}};
}

/// A number that the map does not hold.
double unused_number(std::span<const double> values) {
  double mark = -9999.0;
  while (std::find(values.begin(), values.end(), mark) != values.end()) mark = mark * 10.0 - 9.0;
  return mark;
}

void append_row(const MapView& map, int row, char separator, const std::string& no_data,
                std::string& text) {
  const auto width = static_cast<std::size_t>(map.columns);
  for (std::size_t column = 0; column < width; ++column) {
    const double value = map.values[static_cast<std::size_t>(row) * width + column];
    if (column > 0) text += separator;
    if (std::isnan(value))
      text += no_data;
    else
      fmt::format_to(std::back_inserter(text), "{}", value);
  }
  text += '\n';
}

std::string map_rows(const MapView& map, char separator, const std::string& no_data) {
  std::string text;
  for (int row = 0; row < map.rows; ++row) append_row(map, row, separator, no_data, text);
  return text;
}

std::uint16_t grey_level(double value, const MapView& map, const GreyScale& scale) {
  if (std::isnan(value)) {
    if (!scale.no_data_level)
      throw InputError(
          "the map has vertices without data, which a PNG cannot mark; write it as "
          ".tif or .asc");
    return *scale.no_data_level;
  }
  constexpr double most = 65535.0;
  const double level = std::round(value / scale.step);
  if (level >= 0.0 && level <= most) return static_cast<std::uint16_t>(level);
  if (value < 0.0)
    throw InputError(
        fmt::format("the map's number {} is below 0, which a PNG has no level for; "
                    "write it as .tif or .asc",
                    value));
  double greatest = 0.0;
  for (const double other : map.values)
    if (other > greatest) greatest = other;
  throw InputError(
      fmt::format("the map's number {} is beyond level 65535 at {} a level; take at "
                  "least {}, or write it as .tif or .asc",
                  value, scale.step, greatest / most));
}

}  // namespace

MapView map_view(const HeightField& grid, std::span<const double> values,
                 const std::optional<GeoReference>& place) {
  PHYTOBENCH_EXPECT(values.size() == grid.size());
  return {grid.columns(), grid.rows(), values, grid.cell_width(), grid.cell_depth(), place};
}

MapFormat map_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".tif" || ending == ".tiff") return MapFormat::geotiff;
  if (ending == ".asc") return MapFormat::ascii_grid;
  if (ending == ".csv") return MapFormat::csv;
  if (ending == ".png") return MapFormat::png;
  throw InputError(
      fmt::format("{}: maps are not written in that format; end the name in .tif, "
                  ".asc, .csv or .png",
                  file.string()));
}

std::string to_geotiff(const MapView& map) {
  expect_all_values(map);
  const GeoReference place = place_or_metres(map);
  const RasterToWrite raster{map.columns,
                             map.rows,
                             map.values.data(),
                             {place.west, place.column_step, 0.0, place.north, 0.0, place.row_step},
                             place.projection.c_str()};
  std::string bytes;
  const auto take = [](void* receiver, const void* content, std::size_t size) {
    static_cast<std::string*>(receiver)->assign(static_cast<const char*>(content), size);
  };
  const RasterModule& module = raster_module("writing a GeoTIFF");
  RasterMessage message{};
  if (!module.to_geotiff(raster, &bytes, take, &message))
    throw InputError(
        fmt::format("the map cannot be written as GeoTIFF ({}); write it as .asc", message.text));
  return bytes;
}

std::string to_ascii_grid(const MapView& map) {
  expect_all_values(map);
  const GeoReference place = place_or_metres(map);
  const double depth = std::abs(place.row_step);
  const double mark = unused_number(map.values);
  std::string text = fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\n", map.columns,
                                 map.rows, place.west, place.north - depth * map.rows);
  text += place.column_step == depth ? fmt::format("cellsize {}\n", depth)
                                     : fmt::format("dx {}\ndy {}\n", place.column_step, depth);
  text += fmt::format("NODATA_value {}\n", mark);
  return text + map_rows(map, ' ', fmt::format("{}", mark));
}

std::string to_number_rows(const MapView& map) {
  expect_all_values(map);
  return map_rows(map, ',', "nan");
}

std::string to_grey_png(const MapView& map, const GreyScale& scale) {
  expect_all_values(map);
  PHYTOBENCH_EXPECT(scale.step > 0.0);
  GreyImage image{.width = map.columns, .height = map.rows, .bits = 16};
  image.levels.reserve(map.values.size());
  for (const double value : map.values) image.levels.push_back(grey_level(value, map, scale));
  return to_png(image);
}

std::vector<FileContent> map_files(const std::filesystem::path& file, const MapView& map,
                                   const GreyScale& scale) {
  switch (map_format(file)) {
    case MapFormat::geotiff:
      return {{file, to_geotiff(map)}};
    case MapFormat::csv:
      return {{file, to_number_rows(map)}};
    case MapFormat::png:
      return {{file, to_grey_png(map, scale)}};
    case MapFormat::ascii_grid:
      break;
  }
  std::vector<FileContent> files{{file, to_ascii_grid(map)}};
  if (map.place && !map.place->projection.empty()) {
    std::filesystem::path beside = file;
    files.push_back({beside.replace_extension(".prj"), map.place->projection});
  }
  return files;
}

}  // namespace phytobench
