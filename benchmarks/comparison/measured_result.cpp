// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/measured_result.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/timed_block.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/record/environment.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

constexpr std::uint64_t stream_of_results = 5;  // 0 to 4 are those of comparisons

class ResultTimer {
 public:
  explicit ResultTimer(const ResultRequest& request) : request_(request) {
    PHYTOBENCH_EXPECT(request.side != nullptr && !request.names.empty());
    PHYTOBENCH_EXPECT(request.processes >= 1 && request.samples >= 1 && request.sample_ms > 0.0);
    result_.origin = request.origin;
    result_.machine = request.machine;
    result_.seed = request.seed;
  }

  StoredResult measured() {
    judge();
    calibrate();
    for (int process = 0; process < request_.processes && !iterations_.empty(); ++process)
      time(process);
    refer();
    return std::move(result_);
  }

 private:
  void step(const std::string& line) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted("nothing is kept");
    if (request_.show_progress) request_.show_progress(line);
  }

  StoredBenchmark& benchmark(const std::string& name) {
    const auto found = std::find_if(result_.benchmarks.begin(), result_.benchmarks.end(),
                                    [&](const StoredBenchmark& b) { return b.name == name; });
    PHYTOBENCH_EXPECT(found != result_.benchmarks.end());
    return *found;
  }

  void judge() {
    step("answers are judged");
    for (const VerifiedBenchmark& verified : request_.side->verify(request_.names))
      result_.benchmarks.push_back({.name = verified.name,
                                    .inputs = verified.inputs,
                                    .answer = verified.answer,
                                    .objection = verified.objection,
                                    .is_by_process = true});
  }

  void calibrate() {
    std::vector<std::string> right;
    for (const StoredBenchmark& judged : result_.benchmarks)
      if (judged.objection.empty()) right.push_back(judged.name);
    if (right.empty()) return;
    step("samples are sized");
    for (const CalibratedBenchmark& calibrated :
         request_.side->calibrate(right, request_.sample_ms)) {
      StoredBenchmark& own = benchmark(calibrated.name);
      if (calibrated.iterations == 0)
        own.objection = no_time_to_measure;
      else
        iterations_.push_back({own.name, calibrated.iterations, own.answer});
    }
  }

  void time(int process) {
    step(fmt::format("process {} of {}", process + 1, request_.processes));
    const SamplePlan plan{
        .seed = drawn_seed(request_.seed, stream_of_results, static_cast<std::uint64_t>(process)),
        .samples = request_.samples,
        .benchmarks = iterations_};
    for (const SampledBenchmark& sampled : request_.side->sample(plan)) keep(sampled);
  }

  void keep(const SampledBenchmark& sampled) {
    StoredBenchmark& own = benchmark(sampled.name);
    if (sampled.objection.empty() && seconds_per_iteration(sampled) > 0.0) {
      std::vector<double> seconds;
      for (const TimedSample& sample : sampled.samples)
        seconds.push_back(sample.cpu_s / static_cast<double>(sample.iterations));
      own.processes.push_back(std::move(seconds));
      return;
    }
    own.objection = sampled.objection.empty() ? std::string(no_time_to_measure) : sampled.objection;
    own.processes.clear();
    std::erase_if(iterations_,
                  [&](const SamplePlan::Benchmark& b) { return b.name == sampled.name; });
  }

  void refer() {
    if (request_.reference.empty()) return;
    const std::vector<double> seconds = benchmark(request_.reference).repetitions();
    if (!seconds.empty())
      result_.reference = ReferenceTime{.name = request_.reference, .seconds = median(seconds)};
  }

  const ResultRequest& request_;
  StoredResult result_;
  std::vector<SamplePlan::Benchmark> iterations_;  ///< of what has no objection
};

}  // namespace

ResultMachine this_result_machine() {
  const Machine machine = this_machine();
  ResultMachine described;
  described.processor = machine.processor;
  described.logical_processors = machine.logical_processors;
  described.kernel = machine.kernel;
  return described;
}

StoredResult measure_result(const ResultRequest& request) {
  return ResultTimer(request).measured();
}

}  // namespace phytobench
