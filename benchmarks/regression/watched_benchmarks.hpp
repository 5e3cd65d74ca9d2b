// SPDX-License-Identifier: MIT
// What is watched for loss of speed: fixed work on fixed inputs with one right answer. The same
// object is judged by an oracle, counted, run under callgrind and timed.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Deterministic work of one run, by the counter's name ("search_evaluations").
using WorkCounts = std::map<std::string, std::uint64_t>;

/// Inputs in memory, ready to run again and again.
class WatchedKernel {
 public:
  virtual ~WatchedKernel() = default;

  /// SHA-256 of everything the work depends on. Two builds may be compared where it is equal.
  virtual std::string inputs() const = 0;

  /// The work, once: nothing but what the benchmark is named after.
  virtual void run() = 0;

  /// SHA-256 of the answer of the last run().
  virtual std::string answer() const = 0;

  /// Work of the last run().
  virtual WorkCounts work() const = 0;

  /// Compares the answer of the last run() with one found independently. One line that says what
  /// is wrong with it; empty if nothing. May take much longer than run().
  virtual std::string objection() = 0;
};

struct WatchedBenchmark {
  std::string name;     ///< "nearest-node/voxel_grid/dn"; unique, [a-z0-9./_-]
  std::string summary;  ///< one sentence
  bool is_own = true;   ///< false where most of the work is another library's
  std::function<std::unique_ptr<WatchedKernel>()> prepare;
};

/// Engines that are no part of the program but are to be watched as its own are.
struct FamilyRequest {
  std::vector<const EngineDescriptor*> extra_engines;
};

/// One constant of this type per file in families/, one line in families.def.
struct BenchmarkFamily {
  std::string_view name;     ///< that of its file
  std::string_view summary;  ///< one sentence
  std::vector<WatchedBenchmark> (*list)(const FamilyRequest&) = nullptr;
};

/// Every family of families.def in that order.
std::vector<const BenchmarkFamily*> benchmark_families();

/// All benchmarks of all families.
std::vector<WatchedBenchmark> watched_benchmarks(const FamilyRequest& request = {});

/// Those whose names match one of the globs ("nearest-node/*", '*' and '?'); all without globs.
/// Throws InputError with the nearest name where a glob without wildcards names none, and
/// NothingSelected where globs match nothing.
std::vector<WatchedBenchmark> chosen_benchmarks(const std::vector<WatchedBenchmark>& all,
                                                const std::vector<std::string>& globs);

}  // namespace phytobench
