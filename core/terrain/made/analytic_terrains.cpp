// SPDX-License-Identifier: MIT
#include "core/terrain/made/analytic_terrains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

namespace {

/// Exact where a right angle or its half makes it a whole number.
double rise_of_slope(double slope_degrees) {
  PHYTOBENCH_EXPECT(slope_degrees >= 0.0 && slope_degrees < 90.0);
  if (slope_degrees == 45.0) return 1.0;
  return std::tan(slope_degrees * (std::numbers::pi / 180.0));
}

/// Distances from the centre in metres: equal but for the sign on both of its sides.
double from_centre(int index, int count, double side) {
  return (index - (count - 1) / 2.0) * side;
}

/// `height(x, y)` with x to the east and y to the south of the centre.
template <class Height>
HeightField made_of(const MapGrid& grid, const Height& height) {
  HeightField field(grid.columns, grid.rows, grid.cell_width, grid.cell_depth);
  for (int row = 0; row < grid.rows; ++row) {
    const double y = from_centre(row, grid.rows, grid.cell_depth);
    for (int column = 0; column < grid.columns; ++column)
      field.at(column, row) = height(from_centre(column, grid.columns, grid.cell_width), y);
  }
  return field;
}

}  // namespace

HeightField flat_terrain(const MapGrid& grid, double height_m) {
  return {grid.columns, grid.rows, grid.cell_width, grid.cell_depth, height_m};
}

HeightField plane_terrain(const MapGrid& grid, double slope, double aspect) {
  const double rise = rise_of_slope(slope);
  const SunDirection downhill = direction_of({.elevation = 0.0, .azimuth = aspect});
  return made_of(grid, [&](double x, double y) {
    return 0.0 - rise * (x * downhill.east + y * downhill.south);
  });
}

HeightField ridge_terrain(const MapGrid& grid, double slope) {
  const double rise = rise_of_slope(slope);
  const double border = (grid.rows - 1) / 2.0 * grid.cell_depth;
  return made_of(grid, [&](double, double y) { return rise * (border - std::abs(y)); });
}

HeightField v_valley_terrain(const MapGrid& grid, double slope) {
  const double rise = rise_of_slope(slope);
  return made_of(grid, [&](double, double y) { return rise * std::abs(y); });
}

HeightField crease_terrain(const MapGrid& grid, double slope) {
  const double rise = rise_of_slope(slope);
  return made_of(grid, [&](double x, double) { return rise * std::max(x, 0.0); });
}

HeightField cone_terrain(const MapGrid& grid, double slope, double base_radius_m) {
  const double rise = rise_of_slope(slope);
  return made_of(grid, [&](double x, double y) {
    return rise * std::max(base_radius_m - std::sqrt(x * x + y * y), 0.0);
  });
}

HeightField hemisphere_terrain(const MapGrid& grid, double radius_m) {
  return made_of(grid, [&](double x, double y) {
    return std::sqrt(std::max(radius_m * radius_m - (x * x + y * y), 0.0));
  });
}

HeightField ring_wall_terrain(const MapGrid& grid, double radius_m, double thickness_m,
                              double height_m) {
  return made_of(grid, [&](double x, double y) {
    const double distance = std::sqrt(x * x + y * y);
    return distance >= radius_m && distance < radius_m + thickness_m ? height_m : 0.0;
  });
}

HeightField needle_terrain(const MapGrid& grid, double height_m) {
  HeightField field = flat_terrain(grid, 0.0);
  field.at(grid.columns / 2, grid.rows / 2) = height_m;
  return field;
}

}  // namespace phytobench
