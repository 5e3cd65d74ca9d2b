// SPDX-License-Identifier: MIT
// The index of Clark and Evans 1954, and what distances to nearest neighbours are under complete
// spatial randomness.
#pragma once

#include <cstddef>
#include <span>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Mean distance from a random place to the nearest of `count` independent uniform points.
/// On a torus exact, by integrating (1 - area of a disc / area)^count, where large discs go round.
/// In other windows Donnelly's approximation for the distance among count + 1 points, 0.5 sqrt(A/n)
/// + (0.0514 + 0.0412 / sqrt n) P / n with n = count + 1: the nearer to a square, the better. At
/// least one point.
double expected_nearest_distance(const Window& window, std::size_t count);

/// Aggregation index of a pattern.
struct ClarkEvansIndex {
  double mean_distance = 0.0;      ///< to the nearest neighbour
  double expected_distance = 0.0;  ///< under complete spatial randomness, edges allowed for
  double ratio = 0.0;              ///< R: below 1 clustered, above 1 regular
  double naive_ratio = 0.0;        ///< against 0.5 / sqrt(density), as Clark and Evans have it
  double z = 0.0;                  ///< in standard errors; below 0 clustered
  double p_value = 0.0;            ///< two-sided, normal approximation
};

/// Donnelly 1978: expectation with edges, standard error sqrt(0.0703 A / n^2 + 0.037 P sqrt(A /
/// n^5)); on a torus the exact expectation and the first term alone. NaN for fewer than two points;
/// z and p_value also where the window is so thin, or points so few, that its edge is near to most
/// of them: the approximations are for compact windows.
ClarkEvansIndex clark_evans(std::span<const Point2> points, const Window& window, int threads = 1);

}  // namespace phytobench
