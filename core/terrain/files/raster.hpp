// SPDX-License-Identifier: MIT
// What the readers of the formats hand over, before anything is turned into metres.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/terrain/files/height_file.hpp"

namespace phytobench {

inline constexpr std::int64_t most_vertices = std::int64_t{1} << 28;

/// What the coordinates of a GeoReference count.
struct CoordinateUnit {
  enum class Kind {
    not_said,
    degrees,
    lengths,  ///< of `metres` each
  };
  Kind kind = Kind::not_said;
  double metres = 1.0;
};

struct Raster {
  int columns = 0;
  int rows = 0;
  std::vector<double> values;  ///< row by row from the north; NaN where there is no data
  std::optional<GeoReference> place;
  CoordinateUnit unit;
  std::string height_unit;   ///< as the file calls it; empty: not said
  bool has_palette = false;  ///< the values are numbers of colours
  std::string format;
};

/// Throws InputError for a size of which there is no map, or none that fits; `place` stands for
/// file and line.
void check_raster_size(std::int64_t columns, std::int64_t rows, const std::string& place);

/// By the first bytes and the ending of the file's name. Throws InputError.
Raster read_raster(const std::filesystem::path& file);

}  // namespace phytobench
