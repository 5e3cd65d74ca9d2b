// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace phytobench {

/// Area that two discs have in common (a lens, where neither holds the other): 0 for
/// distance >= r + s, the smaller disc for distance <= |r - s|. [Alsweis] (A.4), corrected.
///
/// As a function of its three arguments the result is right to a relative error of 1e-14, however
/// near the circles are to touching from outside or inside; where the distance itself is rounded,
/// as from coordinates, 1.5 eps d / (r + s - d) come on top, which no formula can avoid. Symmetric
/// in the radii to the last bit. Radii and distance >= 0; what is not zero between 1e-70 and 1e70.
/// NaN if one of them is.
double lens_area(double r, double s, double distance);

/// The same for many pairs at once, in the widest vectors the processor has and to the last bit as
/// lens_area() has it on every processor. All spans have one length; `area` may be one of the
/// others.
void lens_areas(std::span<const double> r, std::span<const double> s,
                std::span<const double> distance, std::span<double> area);

}  // namespace phytobench
