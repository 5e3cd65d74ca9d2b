// SPDX-License-Identifier: MIT
// Google Benchmark suite: every built engine x loop option x size of the test tree of [Brzoska2019]
// Table 1. An engine that differs from the oracle in any iteration is skipped with the difference
// as its message. Choose with --benchmark_filter: the scans take long at the largest size.
#include <map>
#include <memory>

#include "benchmarks/google_benchmark_suite.hpp"
#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

constexpr double sizes[] = {2'000, 25'298, 100'000};

struct JudgedWorkload {
  Workload workload;
  GrowthOracle oracle;

  explicit JudgedWorkload(double points)
      : workload(scaled_test_tree({.points = points})), oracle(workload.seedling) {}
};

const JudgedWorkload& workload_of(double points) {
  static std::map<double, std::unique_ptr<JudgedWorkload>> workloads;
  auto& workload = workloads[points];
  if (!workload) workload = std::make_unique<JudgedWorkload>(points);
  return *workload;
}

void grow(benchmark::State& state, double points, const EngineDescriptor& engine,
          std::string_view option) {
  const JudgedWorkload& judged = workload_of(points);
  const GrowthRun run{.options = loop_options_named(option)};
  const CheckedGrowth checked = grow_checked(engine, judged.workload.seedling, judged.oracle, run);
  if (!checked.verified) {
    state.SkipWithError(checked.disagreement.c_str());
    return;
  }
  for (auto _ : state) state.SetIterationTime(checked.verified->grow().seconds.total);
  const WorkCounters& work = checked.result.work;
  state.counters["search_evaluations"] = static_cast<double>(work.search_evaluations);
  state.counters["kill_evaluations"] = static_cast<double>(work.kill_evaluations);
  state.counters["queries"] = static_cast<double>(work.queries);
}

void register_all() {
  for (const double points : sizes)
    for (const EngineDescriptor* engine : all_engines()) {
      if (!engine->built()) continue;
      for (const std::string_view option : loop_option_names) {
        const std::string name = "points:" + std::to_string(static_cast<int>(points)) + "/" +
                                 std::string(engine->name) + "/" + std::string(option);
        register_benchmark(name, [points, engine, option](benchmark::State& state) {
          grow(state, points, *engine, option);
        })->UseManualTime();
      }
    }
}

}  // namespace
}  // namespace phytobench

int main(int argc, char** argv) {
  return phytobench::run_suite(argc, argv, phytobench::register_all);
}
