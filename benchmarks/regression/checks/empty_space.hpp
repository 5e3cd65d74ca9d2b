// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/voronoi.hpp"

namespace phytobench {

/// Distance from a random place of the window to the nearest point, without search or graph: the
/// cell of each point is the window, cut by the bisectors with all others, and falls into triangles
/// whose integrals have a closed form. Of points at one place the first has the cell. At least one
/// point, all in the window. Exact up to rounding. Time n^2. Throws ContractViolation where the
/// cells do not add up to the window.
EmptySpaceMoments empty_space_by_all_bisectors(std::span<const Point2> points,
                                               const Rectangle& window);

}  // namespace phytobench
