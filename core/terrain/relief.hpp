// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/vector3.hpp"
#include "core/terrain/height_field.hpp"

namespace phytobench {

/// How the surface at a vertex is found from the heights around it. None of them looks at the
/// vertex' own height.
enum class SurfaceEstimator {
  sobel,       ///< eight neighbours, weighted 1 2 1 ([Lesser2019] eq. 8.3 over 8 cells)
  six_faces,   ///< the faces of a mesh with diagonals from south-west to north-east, by area
  other_six,   ///< the same with diagonals from north-west to south-east
  unit_faces,  ///< six_faces with every face weighing the same
};

/// Rise towards east and south, m/m. NaN at vertices without data.
struct SurfaceGradient {
  double east = 0.0;
  double south = 0.0;
};

/// At the border, and beside vertices without data, what is missing is left out: of faces those
/// that are there are taken, and the Sobel operator takes the border's heights once more, as far as
/// the line through its neighbour goes on. A plane has its slope everywhere.
SurfaceGradient surface_gradient(const HeightField& field, int column, int row,
                                 SurfaceEstimator estimator = SurfaceEstimator::sobel);

/// The unit vector away from the ground: x east, y south, z up.
Vector3 surface_normal(const SurfaceGradient& gradient);

/// Between the surface and a horizontal plane, degrees, 0 to 90.
double slope_degrees(const SurfaceGradient& gradient);

/// Of every vertex, row by row.
std::vector<SurfaceGradient> surface_gradients(const HeightField& field, SurfaceEstimator estimator,
                                               int threads = 1);

}  // namespace phytobench
