// SPDX-License-Identifier: MIT
// Google Benchmark suite: every built engine x loop option on the test tree of [Brzoska2019]
// Table 1. An engine that differs from the oracle in any iteration is skipped with the difference
// as its message.
#include <memory>

#include <benchmark/benchmark.h>

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "reference/data_folder.hpp"

namespace phytobench {
namespace {

struct Workload {
  Seedling seedling;
  GrowthOracle oracle;

  explicit Workload(Seedling s) : seedling(std::move(s)), oracle(seedling) {}
};

const Workload& test_tree() {
  static const Workload workload(make_seedling(
      read_tree_parameters(paper_folder("brzoska2019") / "parameters.toml", {"tree.figure-51"})));
  return workload;
}

void grow_test_tree(benchmark::State& state, const EngineDescriptor& engine,
                    std::string_view option) {
  const Workload& workload = test_tree();
  const GrowthRun run{.options = loop_options_named(option)};
  const CheckedGrowth checked = grow_checked(engine, workload.seedling, workload.oracle, run);
  if (!checked.verified) {
    state.SkipWithError(checked.disagreement.c_str());
    return;
  }
  for (auto _ : state) {
    state.SetIterationTime(checked.verified->grow().seconds.total);
  }
  const WorkCounters& work = checked.result.work;
  state.counters["search_evaluations"] = static_cast<double>(work.search_evaluations);
  state.counters["kill_evaluations"] = static_cast<double>(work.kill_evaluations);
  state.counters["queries"] = static_cast<double>(work.queries);
}

void register_all() {
  for (const EngineDescriptor* engine : all_engines()) {
    if (!engine->built()) continue;
    for (const std::string_view option : loop_option_names) {
      const std::string name = "test_tree/" + std::string(engine->name) + "/" + std::string(option);
      benchmark::RegisterBenchmark(
          name.c_str(),
          [engine, option](benchmark::State& state) { grow_test_tree(state, *engine, option); })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace
}  // namespace phytobench

int main(int argc, char** argv) {
  phytobench::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
