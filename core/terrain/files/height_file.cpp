// SPDX-License-Identifier: MIT
#include "core/terrain/files/height_file.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/files/coordinate_unit.hpp"
#include "core/terrain/files/raster.hpp"

namespace phytobench {

namespace {

/// "row 3, column 5", counted from 1 in the north-west.
std::string place_in_map(std::size_t index, int columns) {
  const std::size_t width = static_cast<std::size_t>(columns);
  return fmt::format("row {}, column {}", index / width + 1, index % width + 1);
}

void check_conversion(double conversion, const std::string& name) {
  if (!std::isfinite(conversion) || conversion <= 0.0)
    throw InputError(fmt::format(
        "{}: height_conversion = {} makes no metres; give a number above 0", name, conversion));
}

/// Heights in another unit are only taken if somebody has said how long it is.
void check_height_unit(const Raster& raster, double conversion, const std::string& name) {
  constexpr std::array metres{"", "m", "metre", "metres", "meter", "meters"};
  for (const char* word : metres)
    if (raster.height_unit == word) return;
  if (conversion == 1.0)
    throw InputError(
        fmt::format("{}: its heights are in '{}', not in metres; set "
                    "height_conversion to the metres of one (a foot has 0.3048)",
                    name, raster.height_unit));
}

double height_in_metres(double value, double conversion, const std::string& name, std::size_t index,
                        int columns) {
  if (std::isnan(value)) return HeightField::no_data;
  const double height = value * conversion;
  // Farther up or down than the Earth's radius something else is meant, such as a mark for no data.
  constexpr double most_m = 6.4e6;
  if (!(std::abs(height) <= most_m))
    throw InputError(
        fmt::format("{}: {}: {} is no height in metres; if it stands for no data, "
                    "convert the file such that it says so",
                    name, place_in_map(index, columns), height));
  return height;
}

std::int16_t whole_number(double value, const std::string& name, std::size_t index, int columns) {
  if (std::isnan(value)) return -1;
  if (value != std::floor(value) || value < 0.0 || value > std::numeric_limits<std::int16_t>::max())
    throw InputError(
        fmt::format("{}: {}: {} is no whole number from 0 to 32767; give each vertex "
                    "one",
                    name, place_in_map(index, columns), value));
  return static_cast<std::int16_t>(value);
}

}  // namespace

HeightFile read_height_file(const std::filesystem::path& file, const HeightFileOptions& options) {
  const std::string name = file.string();
  check_conversion(options.height_conversion, name);
  Raster raster = read_raster(file);
  if (raster.has_palette)
    throw InputError(name + ": holds numbers of colours, not heights; give a map of heights");
  check_height_unit(raster, options.height_conversion, name);
  const CellSize cell = cell_size(raster, options, name);
  bool has_any = false;
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    double& value = raster.values[i];
    value = height_in_metres(value, options.height_conversion, name, i, raster.columns);
    has_any = has_any || !std::isnan(value);
  }
  if (!has_any)
    throw InputError(name + ": no vertex has data; is the mark for no data the right one?");
  HeightField field(raster.columns, raster.rows, cell.width, cell.depth, std::move(raster.values));
  return {std::move(field), std::move(raster.place), std::move(raster.format)};
}

NumberMap read_number_map(const std::filesystem::path& file) {
  const Raster raster = read_raster(file);
  NumberMap map{
      .columns = raster.columns, .rows = raster.rows, .numbers = {}, .place = raster.place};
  map.numbers.reserve(raster.values.size());
  for (std::size_t i = 0; i < raster.values.size(); ++i)
    map.numbers.push_back(whole_number(raster.values[i], file.string(), i, raster.columns));
  return map;
}

}  // namespace phytobench
