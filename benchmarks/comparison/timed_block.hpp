// SPDX-License-Identifier: MIT
// The unit of paired timing: two fresh processes of each side, one after the other. What slows the
// machine down for longer than a process hits both sides, and a steady drift cancels.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/timed_side.hpp"

namespace phytobench {

/// What a block is a pure function of, but for its times.
struct BlockPlan {
  std::uint64_t seed = 0;
  std::uint64_t phase = 0;  ///< 0: base against itself, 1: base against new
  int block = 0;            ///< 0-based
  int samples = 5;          ///< of each benchmark in each process
  std::vector<SamplePlan::Benchmark> benchmarks;
};

struct TimedBlock {
  std::string order;                                     ///< "ABBA" or "BAAB"; A is base
  std::vector<std::vector<SampledBenchmark>> processes;  ///< four, in that order
  /// Of the worker at the place after the last process. The block is none then: sides that were not
  /// timed in turns must not be compared.
  std::optional<WorkerDeath> death = {};
  bool was_busy = false;  ///< the machine did something else: is_busy() for it or a process
};

/// "ABBA" or "BAAB", each as often.
std::string block_order(const BlockPlan& plan);

/// A seed at (seed, stream, index): 53 random bits, which every reader of JSON keeps.
std::uint64_t drawn_seed(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Of the process at a position, 0 to 3, of the block.
std::uint64_t process_seed(const BlockPlan& plan, int position);

/// Whether a process lost the processor to others more often than once in 10 ms of timed work,
/// beyond 5 times.
bool is_busy(const std::vector<SampledBenchmark>& process);

/// More of the machine's processor time than this, taken by other virtual machines, and the block
/// was busy.
inline constexpr double most_stolen_share = 0.02;

struct BlockHooks {
  std::function<double()> stolen_share = {};  ///< of the machine since the last call; may be empty
  std::function<void()> before_process = {};  ///< may be empty; may throw
};

/// Ends with the first worker that dies.
TimedBlock run_block(TimedSide& base, TimedSide& other, const BlockPlan& plan,
                     const BlockHooks& hooks);

/// Median over the samples of one process, of processor time per iteration; 0 if it is not
/// positive in all of them or there are none.
double seconds_per_iteration(const SampledBenchmark& sampled);

}  // namespace phytobench
