// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "benchmarks/regression/worker_protocol.hpp"

namespace phytobench {

/// One build whose benchmarks can be judged and timed, each call in a fresh process. All throw
/// EnvironmentError if that process cannot be started or does not answer.
class TimedSide {
 public:
  virtual ~TimedSide() = default;

  /// Names of its benchmarks.
  virtual std::vector<std::string> names() = 0;

  /// Runs each once and lets an oracle judge the answer.
  virtual std::vector<VerifiedBenchmark> verify(const std::vector<std::string>& names) = 0;

  /// Iterations that take about so long.
  virtual std::vector<CalibratedBenchmark> calibrate(const std::vector<std::string>& names,
                                                     double sample_ms) = 0;

  virtual std::vector<SampledBenchmark> sample(const SamplePlan& plan) = 0;
};

}  // namespace phytobench
