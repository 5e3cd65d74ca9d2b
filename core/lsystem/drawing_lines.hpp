// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/lsystem/drawing.hpp"

namespace phytobench {

/// Segments that follow one another, as one line.
struct DrawnLine {
  std::uint64_t style = 0;
  std::vector<Vector3> points;          ///< at least two
  std::vector<std::uint32_t> segments;  ///< one less: which segment each piece is
};

/// All segments, each in one line: a segment goes on with the line of its style that last ended
/// exactly where it begins. Lines are in the order of their first segments. `style_of` says which
/// segments may share a line.
std::vector<DrawnLine> drawn_lines(
    const Drawing& drawing, const std::function<std::uint64_t(const TurtleSegment&)>& style_of);

}  // namespace phytobench
