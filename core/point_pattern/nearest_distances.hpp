// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// For each point the distance to the nearest other one; infinity if there is none, 0 for points
/// with a twin. Equal bit for bit to the least sqrt(dx*dx + dy*dy) of Window::difference() over a
/// double loop, for any number of threads. Through a cell grid in O(n); where points
/// crowd into few cells, through a balanced tree in O(n log n).
/// Expects all points inside the window's bounding box.
std::vector<double> nearest_distances(std::span<const Point2> points, const Window& window,
                                      int threads = 1);

/// The same from each query to the nearest of `points`, which may lie at the query itself; infinity
/// without points. Expects the queries inside the window's bounding box, too.
std::vector<double> nearest_distances_from(std::span<const Point2> queries,
                                           std::span<const Point2> points, const Window& window,
                                           int threads = 1);

}  // namespace phytobench
