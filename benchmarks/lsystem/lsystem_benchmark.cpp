// SPDX-License-Identifier: MIT
// Google Benchmark suite: every built engine on every system that is raced, in three sizes and both
// lanes (in the stream lane, blocks are copied as they come), and derive() alone. What differs from
// the literal turtle, or makes a wrong word, is skipped with the difference as its message. Choose
// with --benchmark_filter.
#include <map>
#include <memory>

#include "benchmarks/google_benchmark_suite.hpp"
#include "benchmarks/lsystem/derivation_race.hpp"
#include "benchmarks/regression/drawing_kernel.hpp"
#include "core/lsystem/derive.hpp"

namespace phytobench {
namespace {

constexpr double sizes[] = {1e4, 1e6, 1e7};  // segments at most
constexpr std::uint64_t most_modules = 2'000'000;

const std::shared_ptr<DrawnSystem>& system_of(const std::string& name, double segments) {
  static std::map<std::pair<std::string, double>, std::shared_ptr<DrawnSystem>> systems;
  auto& system = systems[{name, segments}];
  if (!system) system = std::make_shared<DrawnSystem>(lsystem_workload(name, segments));
  return system;
}

void draw(benchmark::State& state, const std::string& name, double segments,
          const DerivationEngine& engine, DrawingLane lane) {
  const auto system = system_of(name, segments);
  if (is_skipped(state, engine.objection(system->workload().system))) return;
  const auto kernel = drawing_kernel(engine, system, lane);
  kernel->run();
  if (is_skipped(state, kernel->objection())) return;
  for (auto _ : state) kernel->run();
  for (const auto& [counter, count] : kernel->work())
    state.counters[counter] = static_cast<double>(count);
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(system->workload().segments));
}

void derive_word(benchmark::State& state, const DerivationCase& one) {
  DerivationWork work;
  DeriveOptions options;
  options.steps = one.steps;
  options.work = &work;
  if (one.every_word) options.each_word = [](int, const Word&) {};
  if (is_skipped(state, one.objection(derive(one.system, options)))) return;
  for (auto _ : state) benchmark::DoNotOptimize(derive(one.system, options).symbols.data());
  state.counters["modules_written"] = static_cast<double>(work.modules_written);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(work.modules_written));
}

void register_drawing(const std::string& system, double segments, const DerivationEngine& engine,
                      DrawingLane lane) {
  const std::string name = system + "/segments:" + std::to_string(static_cast<int>(segments)) +
                           "/" + std::string(engine.name) + "/" + std::string(name_of(lane));
  register_benchmark(name, [system, segments, &engine, lane](benchmark::State& state) {
    draw(state, system, segments, engine, lane);
  });
}

void register_all() {
  for (const auto& systems : {bench_systems(), published_systems()})
    for (const BenchSystem& system : systems)
      for (const double segments : sizes)
        for (const DerivationEngine* engine : all_derivation_engines()) {
          if (!engine->built()) continue;
          register_drawing(std::string(system.name), segments, *engine, DrawingLane::stream);
          if (engine->write_planar != nullptr)
            register_drawing(std::string(system.name), segments, *engine, DrawingLane::memory);
        }
  for (const DerivationCase& one : derivation_cases(most_modules)) {
    const std::string name = "derive/" + one.name + "/steps:" + std::to_string(one.steps);
    register_benchmark(name, [one](benchmark::State& state) { derive_word(state, one); });
  }
}

}  // namespace
}  // namespace phytobench

int main(int argc, char** argv) {
  return phytobench::run_suite(argc, argv, phytobench::register_all);
}
