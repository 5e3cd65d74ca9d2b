// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace phytobench {

/// The half width of a leaf's outline at a share [0, 1] of its length: a Catmull-Rom spline through
/// `half_widths` (at least 2), which stand at equal distances from base to tip ([Lintermann1997]
/// sec. 5.1: the outer edge is a spline). Straight on beyond its ends, and nowhere below 0.
double half_width_at(std::span<const double> half_widths, double share);

}  // namespace phytobench
