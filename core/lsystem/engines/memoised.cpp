// SPDX-License-Identifier: MIT
#include "core/lsystem/derivation_engine.hpp"

namespace phytobench::derivation_engines {

namespace {

template <class Segment>
DrawingWork draw_segments(const LSystem& system, int steps, int /*threads*/,
                          const SegmentSink<Segment>& sink) {
  const SegmentStream stream(system, steps);
  return {.bytes_held = stream.block_bytes(), .parts_taken = stream.stream(sink)};
}

template <class Segment>
DrawingWork write_segments(const LSystem& system, int steps, int threads, std::span<Segment> out) {
  const SegmentStream stream(system, steps);
  return {.bytes_held = stream.block_bytes(), .parts_taken = stream.write(out, threads)};
}

}  // namespace

extern const DerivationEngine memoised;
constinit const DerivationEngine memoised{
    .name = "memoised",
    .summary = "Keeps what symbols draw in a few steps, and moves and turns it; builds no word.",
    .source = "rigid motion of equal drawings; the idea is common among writers of fast programs",
    .uses_threads_to_write = true,
    .objection = objection_to_streaming,
    .draw = draw_segments<SpatialSegment>,
    .draw_planar = draw_segments<PlanarSegment>,
    .write = write_segments<SpatialSegment>,
    .write_planar = write_segments<PlanarSegment>,
};

}  // namespace phytobench::derivation_engines
