// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/lsystem/drawing.hpp"
#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

/// How results are stored. Past the cache, memory is not read before it is written: for arrays that
/// no cache holds.
enum class Stores { cached, past_cache };

/// Writes a drawing turned to `heading` and moved to (x, y): as many segments as it has. The same
/// bits on every processor: ((d.x x - d.y y) + move_x, (d.x y + d.y x) + move_y).
void move_block(std::span<const PlanarSegment> drawing, PlaneDirection heading, double x, double y,
                PlanarSegment* out, Stores stores);

/// The same in space. `drawing` holds x of both ends of each segment one after the other, then all
/// y, then all z; a point becomes ((x heading + y left) + z up) + position.
void move_block(const double* drawing, std::size_t count, const TurtleFrame& frame,
                const Vector3& position, SpatialSegment* out);

/// What was stored past the cache is seen by other threads from here on.
void finish_stores();

}  // namespace phytobench
