// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "core/terrain/height_field.hpp"

namespace phytobench {

/// A horizontal direction; (east, south) need not be a unit vector, but must not be 0.
struct Heading {
  double east = 1.0;
  double south = 0.0;
};

struct HorizonOptions {
  /// Radius of the Earth, m, whose curvature lets what is far sink: the drop is distance^2 / (2
  /// radius). Infinity: a flat Earth.
  double earth_radius = std::numeric_limits<double>::infinity();
};

/// The tangent of the horizon's elevation as seen from each vertex in that direction, row by row:
/// the steepest rise to any later point of a line towards it. -infinity where there is none (at the
/// border), NaN where the vertex has no data. Lines pass between vertices as in sheared_sweep, and
/// keep the upper hull of what they have met, so that each point is compared twice on average
/// (Timonen and Westerholm 2010): O(N), whatever the elevation. They say where to look; how steep
/// it rises to there is taken on the vertex' own ray, and so no horizon is too high.
std::vector<double> horizon_tangents(const HeightField& field, const Heading& heading,
                                     const HorizonOptions& options = {});

}  // namespace phytobench
