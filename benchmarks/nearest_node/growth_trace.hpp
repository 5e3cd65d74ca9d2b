// SPDX-License-Identifier: MIT
// One growth written down, to be replayed on any engine: search alone, without growing.
#pragma once

#include <cstdint>
#include <vector>

#include "core/colonization/growth.hpp"

namespace phytobench {

/// What the growth loop asked of an engine, call by call.
struct GrowthTrace {
  struct Step {
    bool is_kill;
    double kill_distance;
    std::vector<SearchableNode> nodes;  ///< new nodes, or killers
  };
  EngineSetup setup;
  std::vector<Step> steps;
};

/// Grows with a trusted engine and writes down the calls.
GrowthTrace record_trace(const EngineDescriptor& engine, const Seedling& seedling,
                         const GrowthRun& run);

struct Replay {
  std::vector<std::uint64_t> assignment_hashes;  ///< one per association
  std::vector<std::uint64_t> removal_hashes;     ///< one per removal
  /// The most that was allocated and not yet freed after any call, beyond what was before the
  /// engine existed. Temporary memory within a call is not seen. Negative where the C library
  /// cannot tell.
  double bytes = -1.0;
};

/// Replays it on a fresh engine.
Replay replay(const GrowthTrace& trace, const EngineDescriptor& engine,
              std::span<const Vector3> points, int threads);

}  // namespace phytobench
