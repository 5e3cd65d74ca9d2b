// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "benchmarks/regression/worker_protocol.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

/// How a worker ended before it had answered.
struct WorkerDeath {
  std::string reason;        ///< one clause: "its worker was killed by signal 11 (...)"
  bool was_stopped = false;  ///< at its limit of time: another try would take as long
  std::string side = {};     ///< "base" or "new" where there are two and it is known
};

/// The worker of a side ended before it had answered, whoever or whatever ended it.
class WorkerDied : public EnvironmentError {
 public:
  WorkerDied(const std::string& message, WorkerDeath death)
      : EnvironmentError(message), death_(std::move(death)) {}

  const WorkerDeath& death() const { return death_; }

 private:
  WorkerDeath death_;
};

/// One build whose benchmarks can be judged and timed, each call in a fresh process. All throw
/// EnvironmentError if that process cannot be started; it is WorkerDied if it does not answer.
class TimedSide {
 public:
  virtual ~TimedSide() = default;

  /// Names of its benchmarks.
  virtual std::vector<std::string> names() = 0;

  /// Runs each once and lets an oracle judge the answer. A benchmark that no worker survives has
  /// that as its objection.
  virtual std::vector<VerifiedBenchmark> verify(const std::vector<std::string>& names) = 0;

  /// Iterations that take about so long.
  virtual std::vector<CalibratedBenchmark> calibrate(const std::vector<std::string>& names,
                                                     double sample_ms) = 0;

  /// All benchmarks of the plan in one process, or none.
  virtual std::vector<SampledBenchmark> sample(const SamplePlan& plan) = 0;
};

}  // namespace phytobench
