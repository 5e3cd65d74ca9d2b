// SPDX-License-Identifier: MIT
// Every nearest-node engine grows the same small tree.
#include <fmt/format.h>

#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "benchmarks/regression/growth_kernel.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench::families {

namespace {

constexpr int points = 6000;

using Subject = std::shared_ptr<GrowthSubject>;

WatchedBenchmark growth_by(const EngineDescriptor& engine, const std::string& option, bool is_own,
                           const Subject& subject) {
  return growth_benchmark(
      {.name = fmt::format("nearest-node/{}/{}", engine.name, option),
       .summary = fmt::format("Grows the test tree with {} attraction points, option {}. {}",
                              points, option, engine.summary),
       .is_own = is_own,
       .engine = &engine,
       .option = option,
       .subject = subject});
}

/// Steps and points share one lattice: many nodes are equally near, so the rule for ties decides.
WatchedBenchmark tied_growth_by(const EngineDescriptor& engine, const Subject& subject) {
  return growth_benchmark(
      {.name = fmt::format("nearest-node/{}/ties", engine.name),
       .summary =
           fmt::format("Grows among points on a lattice, where many nodes are equally near. {}",
                       engine.summary),
       .is_own = engine.library.empty(),
       .engine = &engine,
       .option = "s",
       .subject = subject});
}

std::vector<WatchedBenchmark> list_growths(const FamilyRequest& request) {
  const auto subject =
      std::make_shared<GrowthSubject>([] { return scaled_test_tree({.points = points}).seedling; });
  std::vector<WatchedBenchmark> all;
  for (const EngineDescriptor* engine : all_engines())
    if (engine->built()) all.push_back(growth_by(*engine, "dn", engine->library.empty(), subject));
  // The suite's fastest engine once more with a removal in every iteration.
  all.push_back(growth_by(engine_named("node_driven"), "s", true, subject));
  const auto tied = std::make_shared<GrowthSubject>(
      [] { return with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10)); });
  for (const EngineDescriptor* engine : all_engines())
    if (engine->built() && engine->library.empty()) all.push_back(tied_growth_by(*engine, tied));
  for (const EngineDescriptor* engine : request.extra_engines) {
    all.push_back(growth_by(*engine, "dn", true, subject));
    all.push_back(tied_growth_by(*engine, tied));
  }
  return all;
}

}  // namespace

extern const BenchmarkFamily nearest_node;
constinit const BenchmarkFamily nearest_node{
    .name = "nearest_node",
    .summary = "Growing a small tree with every engine.",
    .list = list_growths,
};

}  // namespace phytobench::families
