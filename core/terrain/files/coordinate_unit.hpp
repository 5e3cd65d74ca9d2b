// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/terrain/files/raster.hpp"

namespace phytobench {

/// What the text of a .prj file says of its coordinates: well-known text of either version, or the
/// older lines "Projection GEOGRAPHIC".
CoordinateUnit unit_of_projection(std::string_view text);

/// For a file that does not say: degrees where all of the map fits onto the globe, a cell is
/// narrower than a tenth of a degree, and it does not begin at (0, 0), as grids of metres without a
/// place do; metres otherwise.
CoordinateUnit likely_unit(const GeoReference& place, int columns, int rows);

/// The lengths of a degree of longitude and latitude there, in metres, on the WGS 84 ellipsoid.
struct DegreeLength {
  double east = 0.0;
  double north = 0.0;
};
DegreeLength degree_length(double latitude_degrees);

/// m between columns and between rows.
struct CellSize {
  double width = 1.0;
  double depth = 1.0;
};

/// What the options say, or else the file; degrees are turned into metres in the middle of the map.
/// `name` stands for the file. Throws InputError where neither says it, only one of two numbers is
/// given although the file has its own, or the map reaches beyond a pole.
CellSize cell_size(const Raster& raster, const HeightFileOptions& options, const std::string& name);

}  // namespace phytobench
