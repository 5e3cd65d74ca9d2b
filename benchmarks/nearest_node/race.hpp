// SPDX-License-Identifier: MIT
// Engines side by side on one workload: first proven exact, then timed in turns.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/nearest_node/pair_floor.hpp"
#include "benchmarks/nearest_node/workload.hpp"

namespace phytobench {

/// One engine with one loop option and one number of threads.
struct Contestant {
  const EngineDescriptor* engine = nullptr;
  std::string option = "dn";
  int threads = 1;

  /// "voxel_grid dn", and "voxel_grid dn, 2 threads" for more than one.
  std::string name() const;
};

/// All combinations, engines first.
std::vector<Contestant> combinations(const std::vector<const EngineDescriptor*>& engines,
                                     const std::vector<std::string>& options,
                                     const std::vector<int>& threads);

/// What the race found out about a contestant.
struct RaceEntry : Contestant {
  enum class State {
    timed,      ///< exact, and timed
    inexact,    ///< differs from the judge: no time
    skipped,    ///< would exceed the budget
    not_built,  ///< its library was not found
  };

  State state = State::not_built;
  double predicted_s = 0.0;  ///< of one growth; 0 if there was no need to predict
  std::string disagreement;  ///< of an inexact one: iteration, point, both nodes, both distances
  std::string tree_hash;
  WorkCounters work;
  double bytes_per_point = -1.0;  ///< held by the engine at most; negative if unknown
  std::vector<PhaseSeconds> rounds;
};

struct RaceRequest {
  const Workload* workload = nullptr;
  std::vector<Contestant> contestants;
  double budget_s = 120.0;  ///< of one growth; what is predicted to take longer is skipped;
                            ///< infinite: nothing is, and nothing is predicted
  bool measure_time = true;
  double timing_s = 60.0;        ///< of all timed rounds together, roughly
  int rounds = 0;                ///< 0: as many as timing_s allows, at most 25
  int least_rounds = 3;          ///< whatever timing_s says; 1 to 25
  std::uint64_t order_seed = 0;  ///< of the order within each round, and of the judge's sample
  double replay_s = std::numeric_limits<double>::infinity();   ///< memory is measured by growing
                                                               ///< again, unless that takes longer
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

struct RaceResult {
  std::vector<RaceEntry> entries;  ///< in the order of the contestants
  std::string judge;
  std::size_t nodes = 0;       ///< of the tree, stem included
  std::size_t iterations = 0;  ///< executed
  PairFloor floor;
};

/// Throws Interrupted when asked to stop.
RaceResult race(const RaceRequest& request);

/// Seconds of one phase in all rounds.
std::vector<double> samples(const RaceEntry& entry, double PhaseSeconds::*phase);

/// Everything but association, removal and growth: the building of what is built once.
double reset_seconds(const PhaseSeconds& seconds);

}  // namespace phytobench
