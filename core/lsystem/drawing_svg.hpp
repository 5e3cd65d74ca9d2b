// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/lsystem/drawing.hpp"

namespace phytobench {

struct DrawingSvgOptions {
  double longer_side = 1000.0;       ///< of the drawing, pixels, > 0
  double azimuth_deg = 90.0;         ///< where a drawing in space is seen from, as Camera has it
  double elevation_deg = 0.0;        ///< the same, [-90, 90]
  double widest_line = 0.0;          ///< pixels; 0: chosen by the drawing
  std::vector<std::string> colours;  ///< "#rrggbb" of colour 0, 1, ..., again from the first after
                                     ///< the last; empty: the page's text colour
};

/// The drawing as a small SVG, x to the right and y up; one in space without perspective, near
/// before far. Lines are joined, and coordinates rounded to a hundredth of a pixel. Lines are as
/// wide as the turtle's widths have it; if these do not differ, as suits the picture, and paler the
/// farther away they are.
/// Throws InputError for more than two million segments and polygons, which nobody could look at,
/// or for a colour that is none.
std::string drawing_svg(const Drawing& drawing, const std::string& title,
                        const DrawingSvgOptions& options = {});

}  // namespace phytobench
