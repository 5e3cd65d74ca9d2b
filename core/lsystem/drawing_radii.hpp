// SPDX-License-Identifier: MIT
// How thick the tubes of a drawing are.
#pragma once

#include <vector>

#include "core/lsystem/drawing_plant.hpp"

namespace phytobench {

/// What radii are chosen by where no width is given in length units.
struct PlantSize {
  double extent = 0.0;       ///< longest side of the box
  double mean_length = 0.0;  ///< of the segments
};
PlantSize plant_size(const Skeleton& skeleton);
PlantSize plant_size(const Drawing& drawing);

/// For a drawing that is nothing but a point.
inline double or_one(double length) {
  return length > 0.0 ? length : 1.0;
}

/// Radius of every node of a tree, or of a line as a tree, in a drawing of that size.
std::vector<double> radii_of(const TurtleTree& tree, const PlantSize& size,
                             const DrawingPlantOptions& options);

/// Nothing left open, so that a width means the same in every line of the drawing.
DrawingPlantOptions options_for_all_lines(const Drawing& drawing, const PlantSize& size,
                                          const DrawingPlantOptions& options);

}  // namespace phytobench
