// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// The line through some of the points, in their order and with both ends, such that none of the
/// others is farther than `tolerance` from the piece that replaces it (Ramer 1972; Douglas and
/// Peucker 1973). A line that doubles back keeps its turns.
std::vector<Point2> simplified_line(const std::vector<Point2>& points, double tolerance);

}  // namespace phytobench
