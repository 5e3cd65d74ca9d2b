// SPDX-License-Identifier: MIT
// Taking times within one process.
#pragma once

#include <vector>

#include "benchmarks/regression/worker_protocol.hpp"

namespace phytobench {

/// Runs a benchmark and judges its answer by its oracle; with work counters where the build has
/// them, `allocations` and `allocated_bytes` of a run that is not the first among them.
VerifiedBenchmark verify_benchmark(const WatchedBenchmark& benchmark);

/// How many iterations last about `sample_s` seconds, > 0. None where even millions take no time.
CalibratedBenchmark calibrate_benchmark(const WatchedBenchmark& benchmark, double sample_s);

struct SamplingOptions {
  /// Every iteration is followed by so much of another one that is not counted: a loss of speed
  /// known exactly on any machine. 0 to 1.
  double handicap = 0.0;
};

/// Times `plan.benchmarks` in an order drawn from `plan.seed`. An answer that is not the one of the
/// plan, before or after any sample, leaves that benchmark without times. Throws InputError for a
/// plan that names none of `benchmarks`, or asks for no iteration.
std::vector<SampledBenchmark> sample_benchmarks(const std::vector<WatchedBenchmark>& benchmarks,
                                                const SamplePlan& plan,
                                                const SamplingOptions& options = {});

}  // namespace phytobench
