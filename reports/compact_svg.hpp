// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace phytobench {

/// An SVG that shows the same in fewer bytes and elements: for a page that holds many. Space
/// between elements goes; neighbouring groups of equal attributes become one, and so do circles of
/// a group that are only outlined, and axes and grids of gnuplot's, whose letters follow them.
/// Corners of gnuplot's lines are rounded to a tenth of a pixel, but not those of its marks: they
/// are defined in another unit. Letters, titles and ids stay.
std::string compact_svg(const std::string& svg);

}  // namespace phytobench
