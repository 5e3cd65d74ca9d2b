// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/measured_result.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/timed_block.hpp"
#include "benchmarks/comparison/worker_deaths.hpp"
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
    survive(right, [&](const std::vector<std::string>& names) {
      for (const CalibratedBenchmark& calibrated :
           request_.side->calibrate(names, request_.sample_ms))
        keep(calibrated);
    });
  }

  void keep(const CalibratedBenchmark& calibrated) {
    StoredBenchmark& own = benchmark(calibrated.name);
    if (calibrated.iterations == 0)
      own.objection = no_time_to_measure;
    else
      iterations_.push_back({own.name, calibrated.iterations, own.answer});
  }

  /// Until the action has succeeded for each of these benchmarks, or it has an objection.
  void survive(const std::vector<std::string>& names,
               const std::function<void(const std::vector<std::string>&)>& action) {
    deaths_.survive(
        names,
        [&](const std::vector<std::string>& some) { return death_in([&] { action(some); }); },
        [&](const std::string& name, const WorkerDeath& death) { refuse(name, death.reason); });
  }

  void time(int process) {
    step(fmt::format("process {} of {}", process + 1, request_.processes));
    std::vector<std::string> left;
    for (const SamplePlan::Benchmark& planned : iterations_) left.push_back(planned.name);
    survive(left, [&](const std::vector<std::string>& names) {
      for (const SampledBenchmark& sampled : request_.side->sample(plan_of(process, names)))
        keep(sampled);
    });
  }

  SamplePlan plan_of(int process, const std::vector<std::string>& names) const {
    SamplePlan plan{
        .seed = drawn_seed(request_.seed, stream_of_results, static_cast<std::uint64_t>(process)),
        .samples = request_.samples,
        .benchmarks = iterations_};
    std::erase_if(plan.benchmarks, [&](const SamplePlan::Benchmark& planned) {
      return std::find(names.begin(), names.end(), planned.name) == names.end();
    });
    return plan;
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
    refuse(sampled.name,
           sampled.objection.empty() ? std::string(no_time_to_measure) : sampled.objection);
  }

  /// Takes away the times that it already has.
  void refuse(const std::string& name, const std::string& objection) {
    StoredBenchmark& own = benchmark(name);
    own.objection = objection;
    own.processes.clear();
    std::erase_if(iterations_, [&](const SamplePlan::Benchmark& b) { return b.name == name; });
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
  WorkerDeaths deaths_;
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
