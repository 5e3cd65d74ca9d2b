// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/race.hpp"

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_nearest_node_output.hpp"
#include "cli/race_plugins.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench::cli {

namespace {

using NearestNodeState = RaceEntry::State;

/// Names the engines that only come close, which have a lane of their own.
const std::string approximate_lane = "approximate";

/// Beyond it, they are grown only if asked for by name.
constexpr std::size_t most_points_unasked = 100'000;

std::vector<const EngineDescriptor*> chosen_engines(const std::vector<std::string>& names) {
  std::vector<const EngineDescriptor*> engines;
  for (const std::string& name : names) {
    if (name == "all") {
      for (const EngineDescriptor* engine : all_engines()) engines.push_back(engine);
      continue;
    }
    if (name == approximate_lane) continue;
    const auto found = std::find_if(all_engines().begin(), all_engines().end(),
                                    [&](const EngineDescriptor* e) { return e->name == name; });
    if (found == all_engines().end())
      throw InputError("unknown engine '" + name + "'; known: all, " + approximate_lane + ", " +
                       known_engine_names());
    engines.push_back(*found);
  }
  return engines;
}

std::vector<std::string> chosen_options(const std::vector<std::string>& names) {
  std::vector<std::string> options;
  for (const std::string& name : names) {
    loop_options_named(name);  // refuses what is unknown
    std::string lower;
    for (const char c : name)
      if (c != '&') lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
    options.push_back(lower);
  }
  return options;
}

Workload chosen_workload(const NearestNodeRaceOptions& options) {
  if (options.cloud.empty())
    return scaled_test_tree({.points = options.points,
                             .density = options.density,
                             .iterations = options.iterations,
                             .seed = options.seed});
  Workload workload =
      workload_from_points(read_points(options.cloud), options.cloud, options.iterations);
  workload.seed = options.seed;
  return workload;
}

/// Rounds as in the race, but few: what the trees lose is the point, not the last percent of time.
std::vector<ApproximateEntry> race_approximate(const NearestNodeRaceOptions& options,
                                               const Workload& workload, const RaceResult& exact) {
  const auto names = [&](const std::string& name) {
    return std::find(options.engines.begin(), options.engines.end(), name) != options.engines.end();
  };
  const std::size_t points = workload.seedling.attraction_points.size();
  if (!names(approximate_lane) && !(names("all") && points <= most_points_unasked)) return {};
  std::vector<std::string> loop_options = chosen_options(options.options);
  if (!names(approximate_lane)) loop_options = {loop_options.back()};  // they take their time
  const auto trusted =
      std::find_if(exact.entries.begin(), exact.entries.end(),
                   [](const RaceEntry& entry) { return entry.state == NearestNodeState::timed; });
  const EngineDescriptor& judge =
      trusted == exact.entries.end() ? engine_named("node_driven") : *trusted->engine;
  return run_approximate_lane(
      workload, judge, loop_options, options.rounds > 0 ? options.rounds : 3,
      [](const std::string& what) {
        if (is_interrupted()) throw Interrupted();
        show_progress(what);
      },
      options.threads.front());
}

/// Races and fills `text` with what is to be printed; returns the exit code.
int race_into(std::string& text, const NearestNodeRaceOptions& options,
              const std::vector<TriedPlugin>& plugins, PluginPulse& pulse) {
  keep_freed_memory();
  auto engines = chosen_engines(options.engines);
  const auto loop_options = chosen_options(options.options);
  const Workload workload = chosen_workload(options);
  const auto loaded = load_raced(plugins, pulse);
  for (const auto& plugin : loaded) engines.push_back(&plugin->descriptor());
  const RaceResult result =
      phytobench::race({.workload = &workload,
                        .contestants = combinations(engines, loop_options, options.threads),
                        .budget_s = options.budget,
                        .rounds = options.rounds,
                        .order_seed = options.seed,
                        .show_progress = show_progress,
                        .is_interrupted = is_interrupted});
  const auto approximate = race_approximate(options, workload, result);
  const NearestNodeRaceOutcome outcome{.options = options,
                                       .workload = workload,
                                       .result = result,
                                       .approximate = approximate,
                                       .plugins = plugins};
  text = options.json ? nearest_node_race_json(outcome) : nearest_node_race_table(outcome);
  const bool wrong =
      std::any_of(result.entries.begin(), result.entries.end(),
                  [](const RaceEntry& e) { return e.state == NearestNodeState::inexact; });
  return wrong || !all_raced(plugins) ? 1 : 0;
}

/// Everything that could start a thread happens in the child.
int race_with_plugins(const NearestNodeRaceOptions& options) {
  const SupervisionLimits limits{.silence_s = options.plugin_limit,
                                 .is_interrupted = is_interrupted};
  auto plugins = try_plugins(options.plugins, limits);
  if (!options.json) print(verdict_lines(plugins) + "\n");
  return run_with_plugins(plugins, limits, [&](PluginPulse& pulse, std::string& text) {
    return race_into(text, options, plugins, pulse);
  });
}

}  // namespace

int race_nearest_node(const NearestNodeRaceOptions& options) {
  chosen_engines(options.engines);  // refuse what is unknown before anything takes time
  chosen_options(options.options);
  catch_interrupts();
  if (!options.plugins.empty()) return race_with_plugins(options);
  PluginPulse unused;
  std::string text;
  const int code = race_into(text, options, {}, unused);
  print(text);
  return code;
}

}  // namespace phytobench::cli
