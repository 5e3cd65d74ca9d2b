// SPDX-License-Identifier: MIT
// Growing a crown with a nearest-node engine, as something to be watched.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "benchmarks/nearest_node/growth_judge.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"

namespace phytobench {

/// A seedling and its right tree, each made when first asked for and shared by all who grow it.
/// For one thread.
class GrowthSubject {
 public:
  explicit GrowthSubject(std::function<Seedling()> make) : make_(std::move(make)) {}

  const Seedling& seedling();
  const GrowthOracle& oracle();

 private:
  std::function<Seedling()> make_;
  std::optional<Seedling> seedling_;
  std::unique_ptr<GrowthOracle> oracle_;
};

struct WatchedGrowth {
  std::string name;
  std::string summary;
  bool is_own = true;
  const EngineDescriptor* engine = nullptr;  ///< built; outlives the benchmark
  std::string option = "dn";                 ///< one of loop_option_names
  std::shared_ptr<GrowthSubject> subject;
};

/// Grows the whole tree in every run, on one thread. The engine's every answer is judged by the
/// literal oracle, and so is the tree of the last run.
WatchedBenchmark growth_benchmark(const WatchedGrowth& growth);

}  // namespace phytobench
