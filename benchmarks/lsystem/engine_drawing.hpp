// SPDX-License-Identifier: MIT
// What an engine draws, for either kind of segment: those of systems in the plane and in space.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>

#include "benchmarks/lsystem/bench_systems.hpp"
#include "core/lsystem/derivation_engine.hpp"

namespace phytobench {

/// The engine's function that hands segments over.
template <class Segment>
auto draw_function(const DerivationEngine& engine) {
  if constexpr (std::is_same_v<Segment, PlanarSegment>)
    return engine.draw_planar;
  else
    return engine.draw;
}

/// The one that writes them; null if it has none.
template <class Segment>
auto write_function(const DerivationEngine& engine) {
  if constexpr (std::is_same_v<Segment, PlanarSegment>)
    return engine.write_planar;
  else
    return engine.write;
}

struct CopiedDrawing {
  std::uint64_t segments = 0;
  std::uint64_t blocks = 0;
  DrawingWork work;
};

/// Copies the blocks that are handed over into an array. What does not fit is counted, too, but
/// not written.
template <class Segment>
CopiedDrawing copy_drawing(const DerivationEngine& engine, const LSystemWorkload& workload,
                           int threads, std::span<Segment> out) {
  CopiedDrawing copied;
  copied.work = draw_function<Segment>(engine)(
      workload.system, workload.steps, threads, [&](std::span<const Segment> block) {
        if (copied.segments + block.size() <= out.size())
          std::copy(block.begin(), block.end(), out.data() + copied.segments);
        copied.segments += block.size();
        ++copied.blocks;
      });
  return copied;
}

}  // namespace phytobench
