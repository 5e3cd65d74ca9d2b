// SPDX-License-Identifier: MIT
// How much a turtle draws, and where, without keeping it: for words whose drawing is too large.
#pragma once

#include <cstdint>
#include <functional>

#include "core/geometry/bounding_box.hpp"
#include "core/lsystem/segment_stream.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {

struct DrawnExtent {
  std::uint64_t segments = 0;
  double length = 0.0;         ///< of all segments together
  BoundingBox segment_box;     ///< empty without segments
  std::uint64_t polygons = 0;  ///< of a stream: none, it passes them over
  BoundingBox polygon_box;     ///< around all corners
};

/// Is given the number of segments so far, now and then; returning false throws Interrupted.
using DrawnProgress = std::function<bool(std::uint64_t segments)>;

/// Of what draw() would draw; throws what it throws.
DrawnExtent drawn_extent(const LSystem& system, const Word& word,
                         const DrawnProgress& progress = {});

/// Of what the stream hands over.
DrawnExtent drawn_extent(const SegmentStream& stream, const DrawnProgress& progress = {});

}  // namespace phytobench
