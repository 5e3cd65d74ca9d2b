// SPDX-License-Identifier: MIT
// Overlap engines side by side on one workload: first proven exact, then timed in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/overlap/overlap_workload.hpp"
#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

struct OverlapContestant {
  const OverlapEngineDescriptor* engine = nullptr;
  int threads = 1;

  /// "layered_grid", and "layered_grid, 2 threads" for more than one.
  std::string name() const;
};

struct OverlapEntry : OverlapContestant {
  enum class State {
    timed,      ///< exact, and timed
    inexact,    ///< differs from the judge: no time
    skipped,    ///< would exceed the budget
    not_built,  ///< its library was not found
  };

  State state = State::not_built;
  double predicted_s = 0.0;
  std::string disagreement;
  OverlapWork work;
  std::vector<double> seconds;  ///< of each round
};

/// One way to compute the areas of all pairs, given radii and distances.
struct LensEntry {
  std::string name;
  std::vector<double> seconds;
};

struct OverlapRaceRequest {
  const OverlapWorkload* workload = nullptr;
  std::vector<OverlapContestant> contestants;
  double budget_s = 120.0;       ///< of one search; what is predicted to take longer is skipped
  double timing_s = 60.0;        ///< of all timed rounds together, roughly
  int rounds = 0;                ///< 0: as many as timing_s allows, at least 3, at most 25
  std::uint64_t order_seed = 0;  ///< of the order within each round, and of the judge's sample
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

struct OverlapRaceResult {
  std::vector<OverlapEntry> entries;  ///< in the order of the contestants
  std::vector<LensEntry> lens;        ///< textbook, scalar, vector; empty without pairs
  std::string judge;
  std::size_t pairs = 0;            ///< that overlap, images apart
  double largest_area_error = 0.0;  ///< relative, of a sample, against a hundred digits
};

/// Throws Interrupted when asked to stop.
OverlapRaceResult race_overlap(const OverlapRaceRequest& request);

}  // namespace phytobench
