// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/timed_block.hpp"

#include "benchmarks/comparison/worker_deaths.hpp"
#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

constexpr int processes_of_block = 4;

/// Streams of the seed: one for orders, one for processes, for each phase.
std::uint64_t stream_of_orders(const BlockPlan& plan) {
  return 2 * plan.phase;
}
std::uint64_t stream_of_processes(const BlockPlan& plan) {
  return 2 * plan.phase + 1;
}

}  // namespace

std::string block_order(const BlockPlan& plan) {
  const double toss =
      random_unit(plan.seed, stream_of_orders(plan), static_cast<std::uint64_t>(plan.block));
  return toss < 0.5 ? "ABBA" : "BAAB";
}

std::uint64_t drawn_seed(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  constexpr double all_bits = 9007199254740992.0;  // 2^53: as many as a random unit has
  return static_cast<std::uint64_t>(random_unit(seed, stream, index) * all_bits);
}

std::uint64_t process_seed(const BlockPlan& plan, int position) {
  PHYTOBENCH_EXPECT(0 <= position && position < processes_of_block);
  return drawn_seed(plan.seed, stream_of_processes(plan),
                    static_cast<std::uint64_t>(processes_of_block * plan.block + position));
}

bool is_busy(const std::vector<SampledBenchmark>& process) {
  double timed_s = 0.0, switches = 0.0;
  for (const SampledBenchmark& sampled : process) {
    switches += static_cast<double>(sampled.involuntary_switches);
    for (const TimedSample& sample : sampled.samples) timed_s += sample.wall_s;
  }
  return switches > 5.0 + timed_s / 0.010;
}

TimedBlock run_block(TimedSide& base, TimedSide& other, const BlockPlan& plan,
                     const BlockHooks& hooks) {
  TimedBlock timed{.order = block_order(plan)};
  if (hooks.stolen_share) hooks.stolen_share();  // from here on
  for (int position = 0; position < processes_of_block; ++position) {
    if (hooks.before_process) hooks.before_process();
    TimedSide& side = timed.order[static_cast<std::size_t>(position)] == 'A' ? base : other;
    timed.death = death_in([&] {
      timed.processes.push_back(side.sample({.seed = process_seed(plan, position),
                                             .samples = plan.samples,
                                             .benchmarks = plan.benchmarks}));
    });
    if (timed.death) return timed;
    timed.was_busy = timed.was_busy || is_busy(timed.processes.back());
  }
  if (hooks.stolen_share && hooks.stolen_share() > most_stolen_share) timed.was_busy = true;
  return timed;
}

double seconds_per_iteration(const SampledBenchmark& sampled) {
  std::vector<double> seconds;
  for (const TimedSample& sample : sampled.samples) {
    if (sample.iterations == 0 || !(sample.cpu_s > 0.0)) return 0.0;
    seconds.push_back(sample.cpu_s / static_cast<double>(sample.iterations));
  }
  return seconds.empty() ? 0.0 : median(seconds);
}

}  // namespace phytobench
