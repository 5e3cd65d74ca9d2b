// SPDX-License-Identifier: MIT
// Answers on point patterns, compared with loops over everything, straight from the definitions.
// Each check returns one line that says what is wrong; empty if nothing. Time n^2.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/point_pattern/hopkins.hpp"

namespace phytobench {

/// The exact index of at least two points in a rectangle with edges: cells cut by all bisectors,
/// distances by a double loop, to 1e-11 of the ratio of means and three times that of the other.
std::string objection_to_hopkins(const HopkinsIndex& found, std::span<const Point2> points,
                                 const Rectangle& window);

/// Ripley's K in a rectangle with the translation correction, to 1e-11 of each value.
std::string objection_to_ripley_k(std::span<const double> found, std::span<const Point2> points,
                                  const Rectangle& window, std::span<const double> distances);

/// Distances to the nearest other point in a window with edges, to the last bit.
std::string objection_to_nearest_distances(std::span<const double> found,
                                           std::span<const Point2> points);

/// Thrown darts: all lie in the window, none is nearer than `distance` to another, and none of
/// 20,000 places chosen with `seed` has room for one more.
std::string objection_to_darts(std::span<const Point2> found, const Window& window, double distance,
                               std::uint64_t seed);

}  // namespace phytobench
