// SPDX-License-Identifier: MIT
// Patterns without any order: points that know nothing of each other.
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/window.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// The binomial process: exactly `count` points, independent and uniform in the window. A larger
/// count keeps the first points. Throws InputError beyond most_points.
std::vector<Point2> uniform_points(const Window& window, std::size_t count, UnitStream& stream);

/// The Poisson process around the origin from the inside out ([Alsweis] eq. 2.6 and 2.7):
/// P_i = sqrt(q_i / (pi intensity)) e_i until |P_i| exceeds the radius; sorted by distance. Two
/// numbers of the stream per point, that for q_i first, and one for the end. Intensity (points per
/// unit area) and radius (length) are finite and > 0. A larger radius keeps the first points.
/// Throws InputError if more than most_points are expected.
std::vector<Point2> poisson_points_outwards(double intensity, double radius, UnitStream& stream);

/// The Poisson process in a window: its number of points is random too, with mean intensity * area.
/// Drawn outwards from the centre of the bounding box to its corners; what lies outside of the
/// window is dropped, so that a long, narrow window costs more draws than it keeps. The limit of
/// most_points holds for the circle.
std::vector<Point2> poisson_points(const Window& window, double intensity, UnitStream& stream);

}  // namespace phytobench
