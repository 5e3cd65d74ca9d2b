// SPDX-License-Identifier: MIT
// Second-order functions of planar point patterns, cumulative over distance. Conventions for all:
// - a pair at distance d counts at r if d <= r;
// - distances are finite, not negative and strictly increasing, in the unit of the coordinates; on
// a
//   torus the last one is below half the shorter side (ContractViolation otherwise);
// - the correction must be defined for the window (edge_correction.hpp), the points must lie
// inside;
// - the result has a value per distance, in squared units, NaN where there is nothing to estimate:
//   fewer than two points (one of each type), or, for the border correction, no point that far from
//   the border;
// - points at the same place are pairs at distance 0;
// - the result has the same bits for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/edge_correction.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Ripley's K (Ripley 1976, J. Appl. Prob. 13): mean number of further points within r of a point,
/// over the density; pi r^2 under complete spatial randomness. With area / (n (n - 1)) in front, so
/// that the mean over n independent uniform points is exactly pi r^2 on a torus, with `translation`
/// as long as r is below the shorter side, and with `isotropic` as long as every circle of radius r
/// around a point of the window meets it. For `border` it is the ratio of two sums and only nearly
/// so.
std::vector<double> ripley_k(std::span<const Point2> points, const Window& window,
                             std::span<const double> distances, EdgeCorrection correction,
                             int threads = 1);

/// K between two types: mean number of points of the second within r of a point of the first, over
/// the second's density; pi r^2 for independent types one of which is completely random. Points of
/// both types at one place are pairs at distance 0.
std::vector<double> cross_ripley_k(std::span<const Point2> first, std::span<const Point2> second,
                                   const Window& window, std::span<const double> distances,
                                   EdgeCorrection correction, int threads = 1);

/// Besag's L = sqrt(K / pi), in units of length: r under complete spatial randomness, with a spread
/// that hardly depends on r. NaN stays NaN.
std::vector<double> l_from_k(std::span<const double> k_values);

/// `steps` equal steps from r_max / steps to r_max, where r_max is the least of a quarter of the
/// shorter side of the bounding box and the radius of a circle that holds 1000 points on average;
/// fewer, but at least 50, for more than 50 000 points, so that one million takes a second. Expects
/// at least one step. Without points r_max is a quarter of the shorter side.
std::vector<double> default_distances(std::size_t points, const Window& window,
                                      std::size_t steps = 128);

}  // namespace phytobench
