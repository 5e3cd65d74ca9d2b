// SPDX-License-Identifier: MIT
// Drawing an L-system with one engine, as something to be watched.
#pragma once

#include <memory>

#include "benchmarks/lsystem/drawing_judge.hpp"
#include "benchmarks/lsystem/lsystem_race.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"

namespace phytobench {

/// A system and, once asked for, the right drawing: the literal turtle takes longer than a run, so
/// all engines share it. For one thread.
class DrawnSystem {
 public:
  explicit DrawnSystem(LSystemWorkload workload) : workload_(std::move(workload)) {}

  const LSystemWorkload& workload() const { return workload_; }
  const DrawingJudge& judge();
  bool planar() const;
  std::string digest() const;

 private:
  LSystemWorkload workload_;
  std::unique_ptr<DrawingJudge> judge_;
};

/// The bush of [Brzoska2019] eq. 7 after so many steps.
LSystemWorkload bush_in_space(int steps);

/// Draws the whole system in every run, on one thread: in the stream lane every block that is
/// handed over is copied into an array, in the memory lane the engine writes it. The engine must be
/// built, have nothing against the system, and outlive the kernel.
std::unique_ptr<WatchedKernel> drawing_kernel(const DerivationEngine& engine,
                                              std::shared_ptr<DrawnSystem> system,
                                              DrawingLane lane);

}  // namespace phytobench
