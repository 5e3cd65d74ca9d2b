// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contract/text_file.hpp"
#include "core/terrain/files/height_file.hpp"
#include "core/terrain/height_field.hpp"

namespace phytobench {

/// A map of numbers to be written, row by row from the north; NaN where there is no data. Sees the
/// numbers, does not keep them.
struct MapView {
  int columns = 0;
  int rows = 0;
  std::span<const double> values;
  double cell_width = 1.0;  ///< m, for maps without a place
  double cell_depth = 1.0;
  std::optional<GeoReference> place;
};

/// `values` belong to the vertices of `grid`, which may be its own heights.
MapView map_view(const HeightField& grid, std::span<const double> values,
                 const std::optional<GeoReference>& place);

/// How numbers become grey levels.
struct GreyScale {
  double step = 1.0;  ///< of the numbers, from one level to the next; level 0 is 0
  /// For vertices without data. Without it they are refused: no level says so by itself.
  std::optional<std::uint16_t> no_data_level;
};

enum class MapFormat {
  geotiff,     ///< .tif: 64 bits a number, place, projection, no data as NaN; needs GDAL
  ascii_grid,  ///< .asc: ESRI ASCII grid, and a .prj where there is a projection
  csv,         ///< .csv: rows of numbers, "nan" where there is no data; no place
  png,         ///< .png: 16 bits a number, rounded; no place
};

/// By the ending of the file's name. Throws InputError for any other.
MapFormat map_format(const std::filesystem::path& file);

/// The bytes of such a file. Numbers in text are as short as they can be to be read back exactly.
/// Throws InputError where GDAL is missing, or refuses the projection.
std::string to_geotiff(const MapView& map);
std::string to_ascii_grid(const MapView& map);
std::string to_number_rows(const MapView& map);
/// Throws InputError for numbers that have no level, saying which step would do.
std::string to_grey_png(const MapView& map, const GreyScale& scale);

/// The file, and what has to lie beside it; for write_files_atomically().
std::vector<FileContent> map_files(const std::filesystem::path& file, const MapView& map,
                                   const GreyScale& scale = {});

}  // namespace phytobench
