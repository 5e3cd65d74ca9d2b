// SPDX-License-Identifier: MIT
// How often pairs occur at a distance, relative to complete spatial randomness. Conventions as in
// ripley.hpp, except that the border correction is not defined here.
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/edge_correction.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// What turns the number of pairs per step of distance into a density per area: the circumference
/// of the circle with the distance asked for as its radius, or with each pair's own.
enum class CircleAt {
  grid,  ///< r: too low for r below the half-width, as half the kernel hangs over 0; NaN at r = 0
  pair,  ///< d (Guan 2007): less biased at short distances; pairs at distance 0 are left out
};

struct SmoothingOptions {
  EdgeCorrection correction = EdgeCorrection::none;  ///< not `border`
  /// Half-width of the Epanechnikov kernel in the unit of the coordinates; 0 takes
  /// stoyan_half_width() for the points asked about (cross-type: for all points of both types).
  double half_width = 0.0;
  CircleAt circle_at = CircleAt::grid;
  int threads = 1;
};

/// 0.15 / sqrt(density) (Stoyan and Stoyan 1994, Fractals, Random Shapes and Point Fields, sec.
/// 15.4, within their range 0.1 to 0.2). Infinite without points.
double stoyan_half_width(std::size_t points, const Window& window);

/// Pair correlation g(r) = K'(r) / (2 pi r): 1 under complete spatial randomness, above it at the
/// distances that clusters favour, 0 where no pair can be. With area / (n (n - 1)) in front, as for
/// K. NaN for fewer than two points. On a torus the last distance and the half-width together must
/// stay below half the shorter side.
std::vector<double> pair_correlation(std::span<const Point2> points, const Window& window,
                                     std::span<const double> distances,
                                     const SmoothingOptions& options);

/// The same from points of the first type to points of the second; NaN unless there are both.
std::vector<double> cross_pair_correlation(std::span<const Point2> first,
                                           std::span<const Point2> second, const Window& window,
                                           std::span<const double> distances,
                                           const SmoothingOptions& options);

}  // namespace phytobench
