// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/terrain/height_field.hpp"

namespace phytobench {

/// Where a map lies on Earth; what a GIS needs to lay another map over it.
struct GeoReference {
  double west = 0.0;         ///< x of the west border of the first column's cell
  double north = 0.0;        ///< y of the north border of the first row's cell
  double column_step = 1.0;  ///< in units of the projection
  double row_step = -1.0;
  std::string projection;  ///< well-known text; empty: none given
};

struct HeightFileOptions {
  /// m for a step of the numbers in the file ([Lesser2019] sec. 8.1.4); 1 unless said.
  double height_conversion = 1.0;
  /// m between columns and between rows; not set: what the file says. Degrees are turned into
  /// metres at the middle of the map (WGS 84), which makes cells that are not square.
  std::optional<double> cell_width;
  std::optional<double> cell_depth;
};

struct HeightFile {
  HeightField field;
  std::optional<GeoReference> place;
  std::string format;  ///< "ESRI ASCII grid", "PNG", "CSV" or GDAL's name
};

/// Reads a map of heights, north at the top: an ESRI ASCII grid (.asc), a grey PNG of 8 or 16 bits,
/// a CSV of rows of numbers, and everything else through GDAL where this build has it. Vertices
/// that the file marks as without data, and NaN in a CSV ("nan" or nothing), are without data.
/// Throws InputError with file (and line) for what is broken, has no vertex with data, is too large
/// (more than 2^28 vertices), or lacks a cell size.
HeightFile read_height_file(const std::filesystem::path& file, const HeightFileOptions& options);

/// A map of whole numbers, such as soil ids, of the same formats; -1 where there is no data. Throws
/// InputError also for a number that is not whole, or outside 0 to 32767.
struct NumberMap {
  int columns = 0;
  int rows = 0;
  std::vector<std::int16_t> numbers;
  std::optional<GeoReference> place = {};
};
NumberMap read_number_map(const std::filesystem::path& file);

}  // namespace phytobench
