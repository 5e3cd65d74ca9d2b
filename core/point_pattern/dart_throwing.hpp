// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/window.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// For `most`: throw until no further point fits.
inline constexpr std::size_t until_saturated = std::numeric_limits<std::size_t>::max();

/// Dart throwing (random sequential adsorption, Matern's third hard-core model): points arrive one
/// by one, each uniform in the part of the window that is at least `distance` (finite, >= 0) away
/// from all earlier ones. On a torus distances go round; the window's edges repel nobody.
/// Stops at `most` points, or when nothing of the window is left: then the pattern is maximal, with
/// about 0.6966 * area / distance^2 points. In the order of arrival.
///
/// Darts are thrown only at cells that may hold free ground; cells in the reach of one point are
/// dropped, the others split when most darts miss (after Ebeida et al. 2012, Computer Graphics
/// Forum 31(2)). Since no free ground is ever dropped and all cells are of one size, the law is
/// that of plain dart throwing. Gaps smaller than 2^-30 of the distance may stay.
///
/// Constant time per point; in a polygon times its corners. ContractViolation for a distance out of
/// range. InputError if more than most_points would fit into the bounding box and are asked for,
/// and for a polygon too thin to be hit.
std::vector<Point2> dart_points(const Window& window, double distance, std::size_t most,
                                UnitStream& stream);

}  // namespace phytobench
