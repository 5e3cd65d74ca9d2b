// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/paired_timing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/judged_pair.hpp"
#include "benchmarks/comparison/steady_seconds.hpp"
#include "benchmarks/comparison/timed_block.hpp"
#include "benchmarks/comparison/worker_deaths.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/statistics/median_interval.hpp"

namespace phytobench {

namespace {

const SampledBenchmark* sampled_named(const std::vector<SampledBenchmark>& process,
                                      const std::string& name) {
  const auto found = std::find_if(process.begin(), process.end(),
                                  [&](const SampledBenchmark& s) { return s.name == name; });
  return found == process.end() ? nullptr : &*found;
}

/// Whether more blocks would tell little more.
bool is_narrow(const std::vector<BlockTimes>& blocks, const TimingSettings& settings) {
  if (blocks.size() < static_cast<std::size_t>(settings.least_blocks)) return false;
  std::vector<double> ratios;
  for (const BlockTimes& block : blocks) ratios.push_back(block.log_ratio());
  const auto interval = median_interval(ratios);
  return interval && interval->high - interval->low < std::log1p(settings.tolerance);
}

/// Control or comparison.
struct Phase {
  std::uint64_t number = 0;
  const char* name = "";
  TimedSide* second = nullptr;  ///< B
  std::vector<BlockTimes> MeasuredBenchmark::*blocks = nullptr;
  double ends_s = 0.0;  ///< by the clock: no block begins that would probably end later
  int kept = 0;
  int redone = 0;
  double longest_s = 0.0;  ///< of its blocks
};

class PairTimer {
 public:
  explicit PairTimer(const PairRequest& request) : request_(request) {
    const TimingSettings& s = request.settings;
    PHYTOBENCH_EXPECT(request.base != nullptr && request.other != nullptr);
    PHYTOBENCH_EXPECT(6 <= s.least_blocks && s.least_blocks <= s.most_blocks);
    PHYTOBENCH_EXPECT(s.samples >= 1 && s.sample_ms > 0.0 && s.tolerance > 0.0);
  }

  PairTiming measure() {
    begin();
    stop_if_interrupted();
    if (!request_.is_same_program) {
      calibrate();
      time_blocks();
    }
    return std::move(result_);
  }

 private:
  double now_s() const { return request_.clock_s ? request_.clock_s() : steady_seconds(); }
  bool is_interrupted() const { return request_.is_interrupted && request_.is_interrupted(); }
  void show(const std::string& line) const {
    if (request_.show_progress) request_.show_progress(line);
  }
  void stop_if_interrupted() const {
    if (is_interrupted()) throw Interrupted("no block was finished");
  }

  void begin() {
    Measured& measured = result_.measured;
    measured.base = request_.base_origin;
    measured.other = request_.other_origin;
    measured.seed = request_.settings.seed;
    measured.is_same_program = request_.is_same_program;
    show("answers are judged");
    JudgedPair judged = judge_pair(*request_.base, *request_.other, request_.names);
    measured.benchmarks = std::move(judged.benchmarks);
    answers_ = std::move(judged.answers);
  }

  MeasuredBenchmark& benchmark(const std::string& name) {
    std::vector<MeasuredBenchmark>& all = result_.measured.benchmarks;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const MeasuredBenchmark& b) { return b.name == name; });
    PHYTOBENCH_EXPECT(found != all.end());
    return *found;
  }

  std::vector<std::string> names_to_time() const {
    std::vector<std::string> names;
    for (const MeasuredBenchmark& benchmark : result_.measured.benchmarks)
      if (benchmark.objection.empty() && benchmark.is_same_work) names.push_back(benchmark.name);
    return names;
  }

  /// Once, on base: both sides run the same iterations.
  void calibrate() {
    if (names_to_time().empty()) return;
    show("samples are sized");
    survive(names_to_time(), [&](const std::vector<std::string>& names) {
      std::optional<WorkerDeath> death = death_in([&] {
        for (CalibratedBenchmark& calibrated :
             request_.base->calibrate(names, request_.settings.sample_ms))
          result_.calibrated.push_back(std::move(calibrated));
      });
      if (death) death->side = "base";
      return death;
    });
    for (const std::string& name : names_to_time())
      if (iterations_of(name) == 0) refuse_unmeasurable(benchmark(name));
  }

  std::uint64_t iterations_of(const std::string& name) const {
    const auto found = std::find_if(
        result_.calibrated.begin(), result_.calibrated.end(),
        [&](const CalibratedBenchmark& calibrated) { return calibrated.name == name; });
    return found == result_.calibrated.end() ? 0 : found->iterations;
  }

  void time_blocks() {
    begin_s_ = now_s();
    const double budget_s = request_.settings.budget_s;
    Phase control{.number = 0,
                  .name = "control",
                  .second = request_.base,
                  .blocks = &MeasuredBenchmark::control,
                  .ends_s = begin_s_ + budget_s / 2.0};
    Phase comparison{.number = 1,
                     .name = "comparison",
                     .second = request_.other,
                     .blocks = &MeasuredBenchmark::blocks,
                     .ends_s = begin_s_ + budget_s};
    try {
      run(control);
      run(comparison);
    } catch (const Interrupted&) {
      if (control.kept == 0) throw;
      result_.was_interrupted = true;
    }
    result_.seconds = now_s() - begin_s_;
  }

  void run(Phase& phase) {
    for (int block = 0; block < request_.settings.most_blocks; ++block) {
      const std::vector<std::string> left = undecided(phase);
      if (left.empty() || (block > 0 && is_out_of_time(phase))) return;
      show(fmt::format("{}: block {} of at most {}, benchmarks left: {}, {:.0f} s of {:.0f} s",
                       phase.name, block + 1, request_.settings.most_blocks, left.size(),
                       now_s() - begin_s_, request_.settings.budget_s));
      survive(left, [&](const std::vector<std::string>& names) {
        return keep_block(phase, plan_of(phase, block, names));
      });
    }
  }

  std::vector<std::string> undecided(const Phase& phase) {
    std::vector<std::string> left;
    for (const std::string& name : names_to_time())
      if (!is_narrow(benchmark(name).*phase.blocks, request_.settings)) left.push_back(name);
    return left;
  }

  BlockPlan plan_of(const Phase& phase, int block, const std::vector<std::string>& names) const {
    BlockPlan plan{.seed = request_.settings.seed,
                   .phase = phase.number,
                   .block = block,
                   .samples = request_.settings.samples,
                   .benchmarks = {}};
    for (const std::string& name : names)
      plan.benchmarks.push_back({name, iterations_of(name), answers_.at(name)});
    return plan;
  }

  void survive(const std::vector<std::string>& names, const WorkerDeaths::Attempt& attempt) {
    deaths_.survive(names, attempt, [&](const std::string& name, const WorkerDeath& death) {
      refuse_dead(benchmark(name), death);
    });
  }

  bool is_out_of_time(const Phase& phase) const { return now_s() + phase.longest_s > phase.ends_s; }

  /// Runs a block until the machine was quiet, within limits: on average one try more than needed.
  /// Keeps nothing of a block in which a worker died.
  std::optional<WorkerDeath> keep_block(Phase& phase, const BlockPlan& plan) {
    for (int redone = 0;; ++redone) {
      const double start_s = now_s();
      const TimedBlock timed = run_block(*request_.base, *phase.second, plan,
                                         {.stolen_share = request_.stolen_share,
                                          .before_process = [&] { stop_if_interrupted(); }});
      if (timed.death) {
        ++result_.dead_blocks;
        return of_its_side(phase, timed);
      }
      phase.longest_s = std::max(phase.longest_s, now_s() - start_s);
      if (timed.was_busy && phase.redone <= phase.kept && !is_out_of_time(phase)) {
        ++phase.redone;
        ++result_.redone_blocks;
        continue;
      }
      ++phase.kept;
      if (timed.was_busy) ++result_.busy_blocks;
      for (const SamplePlan::Benchmark& planned : plan.benchmarks)
        keep(phase, timed, benchmark(planned.name),
             {.block = plan.block, .order = timed.order, .redone = redone});
      return std::nullopt;
    }
  }

  static const char* side_at(const Phase& phase, const TimedBlock& timed, std::size_t position) {
    return timed.order[position] == 'B' && phase.number != 0 ? "new" : "base";
  }

  static WorkerDeath of_its_side(const Phase& phase, const TimedBlock& timed) {
    WorkerDeath death = *timed.death;
    death.side = side_at(phase, timed, timed.processes.size());
    return death;
  }

  void keep(const Phase& phase, const TimedBlock& timed, MeasuredBenchmark& benchmark,
            BlockTimes times) {
    std::vector<ProcessSamples> samples;
    for (std::size_t position = 0; position < timed.processes.size(); ++position) {
      const bool is_second = timed.order[position] == 'B';
      const char* whose = side_at(phase, timed, position);
      const SampledBenchmark* sampled = sampled_named(timed.processes[position], benchmark.name);
      if (sampled == nullptr) return refuse(benchmark, whose, "it was not run");
      if (!sampled->objection.empty()) return refuse(benchmark, whose, sampled->objection);
      const double seconds = seconds_per_iteration(*sampled);
      if (!(seconds > 0.0)) return refuse_unmeasurable(benchmark);
      (is_second ? times.other : times.base).push_back(seconds);
      samples.push_back({benchmark.name, phase.number == 0, times.block, static_cast<int>(position),
                         is_second, *sampled});
    }
    (benchmark.*phase.blocks).push_back(std::move(times));
    std::move(samples.begin(), samples.end(), std::back_inserter(result_.samples));
  }

  /// Takes away the times that it already has: a wrong answer gets none.
  void refuse(MeasuredBenchmark& benchmark, const std::string& whose, const std::string& reason) {
    take_times(benchmark);
    benchmark.objection = fmt::format("{}: {}", whose, reason);
  }

  /// Whoever mends a base that dies must not be refused for it, no more than for its wrong answers.
  void refuse_dead(MeasuredBenchmark& benchmark, const WorkerDeath& death) {
    if (death.side != "base") return refuse(benchmark, death.side, death.reason);
    take_times(benchmark);
    benchmark.is_same_work = false;
    benchmark.objection = std::string(base_is_wrong) + death.reason;
  }

  void refuse_unmeasurable(MeasuredBenchmark& benchmark) {
    take_times(benchmark);
    benchmark.is_same_work = false;
    benchmark.objection = no_time_to_measure;
  }

  void take_times(MeasuredBenchmark& benchmark) {
    benchmark.control.clear();
    benchmark.blocks.clear();
    std::erase_if(result_.samples,
                  [&](const ProcessSamples& s) { return s.benchmark == benchmark.name; });
  }

  const PairRequest& request_;
  PairTiming result_;
  std::map<std::string, std::string> answers_;  ///< by name, of what is to be timed
  WorkerDeaths deaths_;
  double begin_s_ = 0.0;
};

}  // namespace

PairTiming measure_pair(const PairRequest& request) {
  return PairTimer(request).measure();
}

}  // namespace phytobench
