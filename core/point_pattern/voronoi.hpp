// SPDX-License-Identifier: MIT
// Voronoi cells within a window, and exact integrals over them: what a random place is near to.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Integrals over the part of the window that is nearer to a point than to all others.
struct CellIntegrals {
  double area = 0.0;
  double distance = 0.0;          ///< of |x - p|
  double squared_distance = 0.0;  ///< of |x - p|^2
  Point2 moment;                  ///< of x - p
};

/// For every point, exact up to rounding. Points must lie in the window. Of points at one place the
/// first has the cell, the others an empty one. Cells of a polygon are what straight lines of sight
/// would leave out, too: only distance counts. Time n log n, whatever the pattern. The same for any
/// number of threads.
std::vector<CellIntegrals> voronoi_integrals(std::span<const Point2> points, const Window& window,
                                             int threads = 1);

/// Corners of every cell, counter-clockwise; on a torus around its point, so that they may lie
/// outside the window; empty for the later ones of points at one place. In a polygon that is not
/// convex a cell may consist of several parts, joined by sides that are gone along twice.
std::vector<std::vector<Point2>> voronoi_cells(std::span<const Point2> points,
                                               const Window& window);

/// Distance from a random place of the window to the nearest point: mean, and mean of the square.
struct EmptySpaceMoments {
  double mean_distance = 0.0;
  double mean_squared_distance = 0.0;
};

/// At least one point.
EmptySpaceMoments empty_space_moments(std::span<const Point2> points, const Window& window,
                                      int threads = 1);

}  // namespace phytobench
