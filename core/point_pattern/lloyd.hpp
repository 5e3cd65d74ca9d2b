// SPDX-License-Identifier: MIT
// The generalised Lloyd method: points move to the centroids of their Voronoi cells, which spreads
// them evenly ([Alsweis] sec. 2.4.1, figure 2.3).
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

struct LloydStep {
  std::vector<Point2> points;  ///< after the step
  /// Before the step: integral of the squared distance to the nearest point, over the area squared.
  /// Times the number of points it is 1 / pi for a random pattern and falls to 5 / (18 sqrt 3) for
  /// the triangular lattice; it never rises from step to step.
  double energy = 0.0;
};

/// One exact step: cells are cut geometrically, not sampled. At least one point; of points at one
/// place the first moves, the others stay. Windows as for voronoi_integrals(); in a polygon that is
/// not convex a centroid outside of it is not taken, the point stays.
LloydStep lloyd_step(std::span<const Point2> points, const Window& window, int threads = 1);

/// `steps` of them.
std::vector<Point2> lloyd_points(std::vector<Point2> points, const Window& window, int steps,
                                 int threads = 1);

}  // namespace phytobench
