// SPDX-License-Identifier: MIT
#include "benchmarks/regression/sampling.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/memory/allocation_counts.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

/// Processor time of this thread, or of this process: what other processes take in between is not
/// in it.
double cpu_seconds(clockid_t whose) {
  timespec now{};
  ::clock_gettime(whose, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

constexpr double shortest_run_s = 20e-9;  ///< an empty call takes a tenth of it

std::int64_t involuntary_switches() {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw;
}

/// Runs `executed` times and says that it was `counted` times.
TimedSample timed(WatchedKernel& kernel, std::uint64_t counted, std::uint64_t executed) {
  const auto wall_start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
  for (std::uint64_t i = 0; i < executed; ++i) kernel.run();
  const double cpu = cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - cpu_start;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - wall_start;
  return {.iterations = counted, .cpu_s = cpu, .wall_s = wall.count()};
}

/// What a sample of no run takes: the shortest of some, so that no interruption is taken for it.
double seconds_of_clocks(WatchedKernel& kernel) {
  double least = timed(kernel, 0, 0).cpu_s;
  for (int i = 0; i < 8; ++i) least = std::min(least, timed(kernel, 0, 0).cpu_s);
  return least;
}

/// Samples of one benchmark, prepared afresh.
class Sampler {
 public:
  Sampler(const WatchedBenchmark& benchmark, const SamplePlan::Benchmark& planned, int samples,
          const SamplingOptions& options, UnitStream& stream)
      : kernel_(benchmark.prepare()),
        planned_(planned),
        samples_(samples),
        options_(options),
        stream_(stream) {
    result_.name = benchmark.name;
  }

  SampledBenchmark run() {
    try {
      warm_up();
      const std::int64_t before = involuntary_switches();
      const double process_start = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
      const double thread_start = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
      for (int sample = 0; sample < samples_ && is_right(); ++sample) take();
      const double elsewhere = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - process_start -
                               (cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - thread_start);
      result_.involuntary_switches = involuntary_switches() - before;
      if (is_right()) demand_one_thread(elsewhere);
      demand_work();
    } catch (const PluginMisbehaved& error) {
      result_.objection = error.what();
    }
    if (!result_.objection.empty()) result_.samples.clear();
    return std::move(result_);
  }

 private:
  /// Memory, caches and branch predictors as later runs will find them.
  void warm_up() {
    for (std::uint64_t i = 0; i < planned_.iterations / 2 + 1; ++i) kernel_->run();
  }

  /// Iterations vary by a fifth, so that no sample falls into step with the clock's ticks.
  void take() {
    const double factor = 0.8 + 0.4 * stream_.next_unit();
    const auto counted = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(
               std::llround(factor * static_cast<double>(planned_.iterations))));
    owed_ += options_.handicap * static_cast<double>(counted);
    const auto extra = static_cast<std::uint64_t>(owed_ + 1e-9);  // ten tenths are one
    owed_ -= static_cast<double>(extra);
    result_.samples.push_back(timed(*kernel_, counted, counted + extra));
  }

  /// A build may have worked when it was calibrated, or the other side alone was. Runs that do
  /// nothing take as long as the clocks around them, which is no work.
  void demand_work() {
    const double clocks_s = seconds_of_clocks(*kernel_);
    for (const TimedSample& sample : result_.samples)
      if (sample.cpu_s < shortest_run_s * static_cast<double>(sample.iterations) + 2.0 * clocks_s)
        result_.objection = "a run takes no time that can be measured";
  }

  /// Work that other threads do would not be in this one's time.
  void demand_one_thread(double seconds_elsewhere) {
    double here = 0.0;
    for (const TimedSample& sample : result_.samples) here += sample.cpu_s;
    constexpr double share = 0.1;      // libraries may keep a thread that wakes now and then
    constexpr double clocks_s = 2e-3;  // clocks of processes tick in steps on some systems
    if (seconds_elsewhere > share * here + clocks_s)
      result_.objection = fmt::format(
          "it computes in other threads, too ({:.1f} times as long as in its own), whose time "
          "would "
          "not be seen",
          seconds_elsewhere / here);
  }

  bool is_right() {
    if (kernel_->answer() == planned_.answer) return true;
    result_.objection = "its answer is not the one that was verified";
    return false;
  }

  std::unique_ptr<WatchedKernel> kernel_;
  const SamplePlan::Benchmark& planned_;
  int samples_;
  const SamplingOptions& options_;
  UnitStream& stream_;
  double owed_ = 0.0;  ///< parts of iterations that the handicap still demands
  SampledBenchmark result_;
};

const WatchedBenchmark& named(const std::vector<WatchedBenchmark>& benchmarks,
                              const std::string& name) {
  for (const WatchedBenchmark& benchmark : benchmarks)
    if (benchmark.name == name) return benchmark;
  throw InputError("there is no benchmark '" + name + "'; see phytobench bench list");
}

}  // namespace

namespace {

VerifiedBenchmark verified_run(const WatchedBenchmark& benchmark) {
  const std::unique_ptr<WatchedKernel> kernel = benchmark.prepare();
  kernel->run();
  const AllocationCounts before = allocations_so_far();
  kernel->run();
  const AllocationCounts after = allocations_so_far();
  VerifiedBenchmark verified{.name = benchmark.name,
                             .inputs = kernel->inputs(),
                             .answer = kernel->answer(),
                             .objection = kernel->objection(),
                             .work = kernel->work()};
  if (counts_inner_loop) {
    verified.work["allocations"] = after.count - before.count;
    verified.work["allocated_bytes"] = after.bytes - before.bytes;
  }
  return verified;
}

CalibratedBenchmark calibrated_run(const WatchedBenchmark& benchmark, double sample_s) {
  constexpr std::uint64_t most_iterations = std::uint64_t{1} << 24;
  const std::unique_ptr<WatchedKernel> kernel = benchmark.prepare();
  kernel->run();
  for (std::uint64_t iterations = 1; iterations <= most_iterations; iterations *= 2) {
    const double seconds = timed(*kernel, iterations, iterations).cpu_s;
    if (seconds < 0.5 * sample_s) continue;
    const double each = seconds / static_cast<double>(iterations);
    if (each < shortest_run_s) break;
    const double wanted = std::max(1.0, std::round(sample_s / each));
    return {
        .name = benchmark.name, .iterations = static_cast<std::uint64_t>(wanted), .seconds = each};
  }
  return {.name = benchmark.name, .iterations = 0, .seconds = 0.0};
}

}  // namespace

VerifiedBenchmark verify_benchmark(const WatchedBenchmark& benchmark) {
  try {
    return verified_run(benchmark);
  } catch (const PluginMisbehaved& error) {
    return {
        .name = benchmark.name, .inputs = {}, .answer = {}, .objection = error.what(), .work = {}};
  }
}

CalibratedBenchmark calibrate_benchmark(const WatchedBenchmark& benchmark, double sample_s) {
  PHYTOBENCH_EXPECT(sample_s > 0.0);
  try {
    return calibrated_run(benchmark, sample_s);
  } catch (const PluginMisbehaved&) {
    return {.name = benchmark.name, .iterations = 0, .seconds = 0.0};  // sampling will say why
  }
}

std::vector<SampledBenchmark> sample_benchmarks(const std::vector<WatchedBenchmark>& benchmarks,
                                                const SamplePlan& plan,
                                                const SamplingOptions& options) {
  if (plan.samples < 1) throw InputError("a plan asks for no sample");
  CounterStream stream(plan.seed, 0);
  std::vector<SampledBenchmark> sampled(plan.benchmarks.size());
  for (const std::size_t i : random_order(plan.benchmarks.size(), stream)) {
    const SamplePlan::Benchmark& planned = plan.benchmarks[i];
    if (planned.iterations < 1)
      throw InputError("a plan asks for no iteration of '" + planned.name + "'");
    sampled[i] =
        Sampler(named(benchmarks, planned.name), planned, plan.samples, options, stream).run();
  }
  return sampled;
}

}  // namespace phytobench
