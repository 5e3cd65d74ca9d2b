// SPDX-License-Identifier: MIT
// Normals of a terrain by both ways of [Lesser2019] sec. 8.3, and soil depths by sec. 8.4 and
// listing 9.15. Shares no code with core/.
#pragma once

#include <array>

#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::oracles::lesser2019 {

struct Normal {
  double x = 0, y = 0, z = 1;  // of length 1; x east, y south, z up
};

// Which diagonal splits the squares of the mesh in two; sec. 9.2.6 has six faces around a vertex,
// and does not say. Compass directions of the map, whose first row is in the north.
enum class Diagonal { south_west_north_east, north_west_south_east };

// What a face's normal weighs in the sum: the length of its cross product, which is twice its area,
// or one. Not printed.
enum class FaceWeight { area, unit };

// Faces that are not on the map, or have a vertex without data, are left out.
Normal normal_of_six_faces(const Heights& map, int i, int j,
                           Diagonal diagonal = Diagonal::south_west_north_east,
                           FaceWeight weight = FaceWeight::area);

// Eq. 8.3 on the pixels around one that is not at the border: plain sums, in metres.
struct SobelSums {
  double S_x = 0, S_y = 0;
};
SobelSums equation_8_3(const Heights& map, int i, int j);

// The sums taken as slopes: as they stand, and over 8 pixels, with y to the south (E17).
Normal sobel_as_printed(const Heights& map, int i, int j);
Normal sobel_corrected(const Heights& map, int i, int j);

// The steepest way to one of the four neighbours on the grid, degrees: sees the vertex itself.
double steepest_edge(const Heights& map, int i, int j);

// Degrees between a normal and the vertical.
double angle_to_vertical(const Normal& n);
// Sec. 8.4: what the dot product with (0, 0, 1) gives, called the angle.
double dot_with_vertical(const Normal& n);

// cm; the angle in degrees.
double listing_9_15(double angle, double max_soil_depth);

}  // namespace phytobench::oracles::lesser2019
