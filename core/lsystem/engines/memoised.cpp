// SPDX-License-Identifier: MIT
#include "core/lsystem/derivation_engine.hpp"

namespace phytobench::derivation_engines {

namespace {

template <class Segment>
std::uint64_t draw_segments(const LSystem& system, int steps, int /*threads*/,
                            const SegmentSink<Segment>& sink) {
  const SegmentStream stream(system, steps);
  stream.stream(sink);
  return stream.block_bytes();
}

template <class Segment>
std::uint64_t write_segments(const LSystem& system, int steps, int threads,
                             std::span<Segment> out) {
  const SegmentStream stream(system, steps);
  stream.write(out, threads);
  return stream.block_bytes();
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
