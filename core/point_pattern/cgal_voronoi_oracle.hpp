// SPDX-License-Identifier: MIT
// Test oracle: Voronoi cells as duals of CGAL's Delaunay triangulation.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench::cgal_oracle {

/// Corners of the cell of each of the first `count` points, counter-clockwise. They must be
/// surrounded by the others, so that no cell is open, and no two points at one place.
std::vector<std::vector<Point2>> voronoi_cells(std::span<const Point2> points, std::size_t count);

}  // namespace phytobench::cgal_oracle
