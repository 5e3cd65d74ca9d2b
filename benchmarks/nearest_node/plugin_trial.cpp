// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/plugin_trial.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "benchmarks/heap_memory.hpp"
#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/nearest_node/growth_trace.hpp"
#include "benchmarks/nearest_node/unusual_calls.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "benchmarks/resident_memory.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench {

namespace {

using Kind = PluginVerdict::Kind;

constexpr std::size_t watched_growths = 6;
constexpr std::size_t settled_growths = 4;  // of these; caches have filled before

struct TrialRun {
  std::string_view option;  ///< of the growth loop; n is nothing to a plugin
  int threads;
};
constexpr TrialRun trial_runs[] = {{"s", 1}, {"d", 1}, {"d", 2}};

/// The first wrong answer; empty if there is none.
std::string disagreement(const EngineDescriptor& engine, const NamedSeedling& tried,
                         const GrowthOracle& oracle, const TrialRun& run) {
  std::string what;
  try {
    what = grow_checked(engine, tried.seedling, oracle,
                        {.options = loop_options_named(run.option), .threads = run.threads})
               .disagreement;
  } catch (const PluginMisbehaved& misbehaved) {
    what = misbehaved.what();
  }
  if (what.empty()) return what;
  return fmt::format("{}, loop option {}{}: {}", tried.name, run.option,
                     run.threads > 1 ? fmt::format(", {} threads", run.threads) : "", what);
}

std::string disagreement(const EngineDescriptor& engine,
                         const std::vector<NamedSeedling>& seedlings) {
  for (const NamedSeedling& tried : seedlings) {
    const GrowthOracle oracle(tried.seedling);
    for (const TrialRun& run : trial_runs)
      if (std::string what = disagreement(engine, tried, oracle, run); !what.empty()) return what;
  }
  return wrong_in_unusual_calls(engine);
}

/// Replays one growth again and again: only the engine allocates. Throws PluginMisbehaved if the
/// answers are not always the same.
MemoryAfterGrowths watch_memory(const EngineDescriptor& engine, const Seedling& seedling) {
  const EngineDescriptor& trusted = engine_named("node_driven");
  const GrowthTrace trace = record_trace(trusted, seedling, {});
  const std::vector<Vector3>& points = seedling.attraction_points;
  const Replay truth = replay(trace, trusted, points, trace.setup.threads);
  MemoryAfterGrowths memory;
  memory.heap.reserve(watched_growths);
  memory.resident.reserve(watched_growths);
  for (std::size_t growth = 0; growth < watched_growths; ++growth) {
    {
      const Replay again = replay(trace, engine, points, trace.setup.threads);
      memory.working = std::max(memory.working, again.bytes);
      if (again.assignment_hashes != truth.assignment_hashes ||
          again.removal_hashes != truth.removal_hashes)
        throw PluginMisbehaved("the same growth again: other answers than before");
    }
    if (const auto bytes = heap_bytes()) memory.heap.push_back(static_cast<double>(*bytes));
#ifndef __SANITIZE_ADDRESS__  // it keeps what is freed
    if (const auto bytes = resident_bytes()) memory.resident.push_back(static_cast<double>(*bytes));
#endif
  }
  return memory;
}

/// The least that any of the last growths added; 0 if one added nothing.
double steady_growth(const std::vector<double>& bytes) {
  if (bytes.size() <= settled_growths) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = bytes.size() - settled_growths; i < bytes.size(); ++i)
    least = std::min(least, bytes[i] - bytes[i - 1]);
  return std::max(least, 0.0);
}

PluginVerdict verdict_on(const EnginePlugin& plugin, const std::vector<NamedSeedling>& seedlings) {
  const EngineDescriptor& engine = plugin.descriptor();
  PluginVerdict verdict{.kind = Kind::wrong, .engine = std::string(engine.name)};
  verdict.detail = disagreement(engine, seedlings);
  if (!verdict.detail.empty()) return verdict;
  const MemoryAfterGrowths memory = watch_memory(engine, seedlings.back().seedling);
  const double leaked = leaked_per_growth(memory);
  verdict.kind = leaked > 0.0 ? Kind::leaks : Kind::exact;
  verdict.detail =
      leaked > 0.0
          ? fmt::format("{:.0f} bytes are left behind by each growth, which holds {:.0f} at most",
                        leaked, memory.working)
          : fmt::format(
                "every answer on {} trees is the literal oracle's, {}", seedlings.size(),
                memory.heap.empty() ? "memory could not be watched" : "and all memory came back");
  return verdict;
}

/// In the child. The kind is the code, the rest two lines.
int run_trial(const std::filesystem::path& file, const std::vector<NamedSeedling>& seedlings,
              PluginPulse& pulse, std::string& output) {
  const EnginePlugin plugin(file, {.pulse = &pulse, .plugin = 0});
  PluginVerdict verdict;
  try {
    verdict = verdict_on(plugin, seedlings);
  } catch (const PluginMisbehaved& misbehaved) {  // it was right the first time
    verdict = {.kind = Kind::wrong,
               .engine = std::string(plugin.descriptor().name),
               .detail = misbehaved.what()};
  }
  output = verdict.engine + "\n" + verdict.detail;
  return static_cast<int>(verdict.kind);
}

PluginVerdict verdict_of(const SupervisedRun& run, const SupervisionLimits& limits) {
  if (run.end != SupervisedRun::End::finished) return verdict_on_unfinished(run, limits);
  const std::size_t line_end = run.output.find('\n');
  PHYTOBENCH_ENSURE(line_end != std::string::npos);
  return {.kind = static_cast<Kind>(run.code),
          .engine = run.output.substr(0, line_end),
          .detail = run.output.substr(line_end + 1)};
}

/// Many calls that each take nearly as long as one may are too many.
SupervisionLimits with_total(SupervisionLimits limits) {
  constexpr double least_s = 60.0, calls = 20.0;
  limits.total_s = std::min(limits.total_s, std::max(least_s, calls * limits.silence_s));
  return limits;
}

}  // namespace

std::string_view name_of(PluginVerdict::Kind kind) {
  switch (kind) {
    case Kind::exact:
      return "exact";
    case Kind::wrong:
      return "wrong";
    case Kind::crashed:
      return "crashed";
    case Kind::hangs:
      return "hangs";
    case Kind::leaks:
      return "leaks";
    case Kind::refused:
      return "refused";
  }
  return "unknown";
}

PluginVerdict verdict_on_unfinished(const SupervisedRun& run, const SupervisionLimits& limits) {
  using End = SupervisedRun::End;
  PHYTOBENCH_EXPECT(run.end != End::finished);
  const bool hangs = run.end == End::silence || run.end == End::overtime;
  return {.kind = hangs                  ? Kind::hangs
                  : run.end == End::lost ? Kind::wrong
                                         : Kind::crashed,
          .detail = described(run, limits)};
}

double leaked_per_growth(const MemoryAfterGrowths& memory) {
  constexpr double share = 0.01, kibibyte = 1024.0, bookkeeping = 64.0;
  const double of_heap = steady_growth(memory.heap);
  if (of_heap > std::clamp(share * memory.working, bookkeeping, kibibyte)) return of_heap;
  const double of_pages = steady_growth(memory.resident);
  if (of_pages > std::max(share * memory.working, 256 * kibibyte)) return of_pages;
  return 0.0;
}

std::vector<NamedSeedling> trial_seedlings() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<NamedSeedling> all;
  all.push_back({"lattice", with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10))});
  all.push_back({"repeated points", seedling_with(repeated(random_cube(200)), 0.6, 0.3, 12)});
  all.back().seedling.growth.perception_angle_rad = 2.0 * std::numbers::pi;
  all.push_back({"unlimited influence", seedling_with(random_cube(300), infinity, 0.3, 10)});
  all.push_back({"test tree of 2000 points", scaled_test_tree({.points = 2000.0}).seedling});
  return all;
}

PluginVerdict try_plugin(const std::filesystem::path& file,
                         const std::vector<NamedSeedling>& seedlings,
                         const SupervisionLimits& limits) {
  PHYTOBENCH_EXPECT(!seedlings.empty());
  const SupervisionLimits bounded = with_total(limits);
  try {
    const SupervisedRun run = run_supervised(
        [&](PluginPulse& pulse, std::string& output) {
          return run_trial(file, seedlings, pulse, output);
        },
        bounded);
    return verdict_of(run, bounded);
  } catch (const InputError& error) {
    return {.kind = Kind::refused, .detail = error.what()};
  }
}

PluginVerdict try_plugin(const std::filesystem::path& file, const SupervisionLimits& limits) {
  return try_plugin(file, trial_seedlings(), limits);
}

}  // namespace phytobench
