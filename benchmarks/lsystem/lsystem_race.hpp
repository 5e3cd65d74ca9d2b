// SPDX-License-Identifier: MIT
// Engines that derive and draw L-systems side by side: first proven right, then timed in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/lsystem/bench_systems.hpp"
#include "core/lsystem/derivation_engine.hpp"

namespace phytobench {

/// Where segments go.
enum class DrawingLane {
  stream,  ///< handed over block by block, in memory that stays in a cache
  memory,  ///< all of them into an array
};
std::string_view name_of(DrawingLane lane);

struct DrawingContestant {
  const DerivationEngine* engine = nullptr;
  int threads = 1;
  DrawingLane lane = DrawingLane::stream;
};

/// Every engine in both lanes, with each number of threads where it uses them and else with one.
std::vector<DrawingContestant> drawing_contestants(
    const std::vector<const DerivationEngine*>& engines, const std::vector<int>& threads);

struct DrawingEntry : DrawingContestant {
  enum class State {
    timed,      ///< right, and timed
    wrong,      ///< differs from the judge: no time
    refused,    ///< the engine does not take the system
    not_built,  ///< its library was not found
  };

  State state = State::not_built;
  std::string objection;         ///< why it is wrong, or refused
  std::uint64_t bytes_held = 0;  ///< at most, beside the segments
  std::vector<double> seconds;   ///< of each round
};

/// One system. All systems have the same contestants in the same order.
struct DrawingRaceResult {
  bool planar = false;
  double bound = 0.0;  ///< by how much a coordinate might be off
  std::vector<DrawingEntry> entries;
};

struct DrawingRaceRequest {
  const LSystemWorkload* workload = nullptr;
  std::vector<DrawingContestant> contestants;
  int rounds = 7;
  std::uint64_t order_seed = 0;                                ///< of the order within each round
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

/// Throws Interrupted when asked to stop.
DrawingRaceResult race_drawings(const DrawingRaceRequest& request);

}  // namespace phytobench
