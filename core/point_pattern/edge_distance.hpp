// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Distance from a point to the window's border, from inside or outside; 0 on the border. Infinite
/// on a torus, which has none.
double distance_to_edge(const Window& window, const Point2& point);

/// distance_to_edge() of each point.
std::vector<double> distances_to_edge(const Window& window, std::span<const Point2> points);

}  // namespace phytobench
