// SPDX-License-Identifier: MIT
// Shadow engines side by side on one workload: first compared with the judge, then timed in turns.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/shadow/shadow_workload.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

struct ShadowContestant {
  const ShadowEngineDescriptor* engine = nullptr;
  int threads = 1;

  /// "max_pyramid", and "max_pyramid, 2 threads" for more than one.
  std::string name() const;
};

struct ShadowEntry : ShadowContestant {
  enum class State {
    timed,      ///< exact, or known to approximate
    wrong,      ///< says that it is exact, and is not: no time
    skipped,    ///< would exceed the budget
    not_built,  ///< its library was not found
  };

  State state = State::not_built;
  double predicted_s = 0.0;
  std::string disagreement;
  double wrong_share = 0.0;           ///< of vertex-hours; 0 for exact ones
  std::optional<std::int64_t> bytes;  ///< at the peak, its maps included, the terrain not
  ShadowWork work;
  std::vector<double> seconds;  ///< of each round
};

struct ShadowRaceRequest {
  const ShadowWorkload* workload = nullptr;
  std::vector<ShadowContestant> contestants;
  double budget_s = 120.0;       ///< of one cast; what is predicted to take longer is skipped
  double timing_s = 60.0;        ///< of all timed rounds together, roughly
  int rounds = 0;                ///< 0: as many as timing_s allows, at least 3, at most 25
  std::uint64_t order_seed = 0;  ///< of the order within each round, and of the judge's sample
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

struct ShadowRaceResult {
  std::vector<ShadowEntry> entries;  ///< in the order of the contestants
  std::string judge;
  std::uint64_t lit = 0;  ///< vertex-hours
};

/// Throws Interrupted when asked to stop.
ShadowRaceResult race_shadows(const ShadowRaceRequest& request);

}  // namespace phytobench
