// SPDX-License-Identifier: MIT
// Terrains whose shadows, slopes and horizons are known in closed form. Each is centred in the map,
// between two vertices where their number is even, and exact at every vertex.
#pragma once

#include "core/terrain/height_field.hpp"

namespace phytobench {

/// How large a map is made.
struct MapGrid {
  int columns = 1;
  int rows = 1;
  double cell_width = 1.0;  ///< m
  double cell_depth = 1.0;  ///< m
};

HeightField flat_terrain(const MapGrid& grid, double height_m);

/// Height 0 in the centre, falling towards `aspect`, in degrees from east over south as a sun's
/// azimuth. Slopes here and below in degrees, 0 to 90 without 90; 45 degrees rise by exactly the
/// distance.
HeightField plane_terrain(const MapGrid& grid, double slope, double aspect);

/// Its crest runs from west to east; both flanks have the slope, down to 0 at the map's border.
HeightField ridge_terrain(const MapGrid& grid, double slope);

/// Two flanks of the slope that rise to the north and south from a line of height 0.
HeightField v_valley_terrain(const MapGrid& grid, double slope);

/// Flat in the west, rising with the slope to the east of the centre.
HeightField crease_terrain(const MapGrid& grid, double slope);

/// A round cone of that slope on flat ground.
HeightField cone_terrain(const MapGrid& grid, double slope, double base_radius_m);

/// The upper half of a ball on flat ground.
HeightField hemisphere_terrain(const MapGrid& grid, double radius_m);

/// A wall around a flat place: all vertices whose distance from the centre is at least `radius_m`
/// and less than `radius_m` + `thickness_m` have the height, all others 0.
HeightField ring_wall_terrain(const MapGrid& grid, double radius_m, double thickness_m,
                              double height_m);

/// One vertex of the height, in the centre or (where that lies between vertices) south-east of it,
/// on flat ground.
HeightField needle_terrain(const MapGrid& grid, double height_m);

}  // namespace phytobench
