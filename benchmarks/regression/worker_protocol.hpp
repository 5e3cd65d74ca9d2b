// SPDX-License-Identifier: MIT
// What `phytobench_worker` is asked and what it answers. The worker is a small program of one
// build: whoever compares builds starts the worker of each and speaks with both alike, so this
// format must stay readable for later versions: fields are added, never changed.
//
//   phytobench_worker list                      WorkerDescription
//   phytobench_worker verify   [NAME...]        VerifiedBenchmark each; answers judged by oracles
//   phytobench_worker counters [NAME...]        the same with work counters
//   phytobench_worker calibrate --sample-ms T [NAME...]   iterations for a sample of that length
//   phytobench_worker sample    < plan          SamplePlan in, SampledBenchmark each out
//   phytobench_worker once NAME                 runs it twice; callgrind counts the second run
// Options of all: --plugin FILE.so (its engine joins), --handicap SHARE (every iteration is
// followed by so much of another: a calibrated loss of speed), --selftest (broken benchmarks join).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/regression/watched_benchmarks.hpp"

namespace phytobench {

inline constexpr int worker_protocol = 1;

struct WorkerDescription {
  struct Benchmark {
    std::string name;
    std::string summary;
    bool is_own = true;
  };
  int protocol = worker_protocol;
  std::string compiler;
  std::string flags;
  bool counts_work = false;  ///< built with counters: never to be timed
  std::vector<Benchmark> benchmarks;
};

struct VerifiedBenchmark {
  std::string name;
  std::string inputs;
  std::string answer;
  std::string objection;  ///< empty if the answer is right
  WorkCounts work;        ///< of `counters` only
};

struct CalibratedBenchmark {
  std::string name;
  std::uint64_t iterations = 0;  ///< 0: a run takes no time that could be measured
  double seconds = 0.0;          ///< of one iteration, roughly
};

/// What a worker shall time in one process.
struct SamplePlan {
  struct Benchmark {
    std::string name;
    std::uint64_t iterations = 0;  ///< of a sample; varied by up to a fifth
    std::string answer;            ///< that was verified; another one gets no time
  };
  std::uint64_t seed = 0;  ///< of the order of benchmarks and the variation of iterations
  int samples = 5;         ///< of each benchmark
  std::vector<Benchmark> benchmarks;
};

struct TimedSample {
  std::uint64_t iterations = 0;
  double cpu_s = 0.0;   ///< of this thread, all iterations together
  double wall_s = 0.0;  ///< the same by the clock
};

struct SampledBenchmark {
  std::string name;
  std::string objection;  ///< why it got no time
  std::vector<TimedSample> samples;
  std::int64_t involuntary_switches = 0;  ///< while it was timed
};

std::string to_json(const WorkerDescription& description);
std::string to_json(const std::vector<VerifiedBenchmark>& verified);
std::string to_json(const std::vector<CalibratedBenchmark>& calibrated);
std::string to_json(const SamplePlan& plan);
std::string to_json(const std::vector<SampledBenchmark>& sampled);

/// Throw InputError beginning with `whose` if the text is none of it, or of another protocol.
WorkerDescription worker_description_from(const std::string& json, const std::string& whose);
std::vector<VerifiedBenchmark> verified_from(const std::string& json, const std::string& whose);
std::vector<CalibratedBenchmark> calibrated_from(const std::string& json, const std::string& whose);
SamplePlan sample_plan_from(const std::string& json, const std::string& whose);
std::vector<SampledBenchmark> sampled_from(const std::string& json, const std::string& whose);

}  // namespace phytobench
