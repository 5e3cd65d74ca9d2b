// SPDX-License-Identifier: MIT
// The parent's side of run_supervised().
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <sys/types.h>

#include "benchmarks/nearest_node/supervised_child.hpp"

namespace phytobench {

/// Looks after one child, the leader of a process group, until it and all of its group have ended.
class Supervisor {
 public:
  /// `pipe` is where the child's output comes from.
  Supervisor(pid_t child, int pipe, const SharedWithChild& shared, const SupervisionLimits& limits)
      : child_(child), pipe_(pipe), shared_(shared), limits_(limits) {}

  /// Ends and reaps a child that is still there: something was thrown.
  ~Supervisor() {
    if (!is_reaped_) end_child();
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// Throws as run_supervised() does.
  SupervisedRun wait();

 private:
  using Clock = std::chrono::steady_clock;

  bool has_ended();
  bool read_output(int milliseconds);
  std::optional<SupervisedRun::End> reason_to_stop();
  bool is_silent_for_too_long();
  void end_child();
  SupervisedRun outcome() const;

  pid_t child_;
  int pipe_;
  const SharedWithChild& shared_;
  const SupervisionLimits& limits_;
  int status_ = 0;
  bool is_reaped_ = false;
  bool is_open_ = true;
  std::optional<SupervisedRun::End> stopped_;  // why it was killed
  std::string output_;
  std::uint64_t beats_ = 0;
  Clock::time_point started_ = Clock::now();
  Clock::time_point since_ = started_;  // the latest beat was seen
};

}  // namespace phytobench
