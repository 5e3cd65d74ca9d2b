// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/race.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_approximate.hpp"
#include "cli/race_numbers.hpp"
#include "cli/race_plugins.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/record/environment.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;
using State = RaceEntry::State;

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

const char* name_of(State state) {
  switch (state) {
    case State::timed:
      return "timed";
    case State::inexact:
      return "inexact";
    case State::skipped:
      return "skipped";
    case State::not_built:
      return "not built";
  }
  return "";
}

std::uint64_t evaluations(const RaceEntry& entry) {
  return entry.work.search_evaluations + entry.work.kill_evaluations;
}

double median_of(const RaceEntry& entry, double PhaseSeconds::*phase) {
  return median(samples(entry, phase));
}

MedianOfRounds total_of(const RaceEntry& entry) {
  return median_of_rounds(samples(entry, &PhaseSeconds::total));
}

MedianOfRounds ratio_of(const RaceEntry& slower, const RaceEntry& faster) {
  return ratio_of_rounds(samples(slower, &PhaseSeconds::total),
                         samples(faster, &PhaseSeconds::total));
}

double median_reset(const RaceEntry& entry) {
  std::vector<double> seconds;
  for (const PhaseSeconds& round : entry.rounds) seconds.push_back(reset_seconds(round));
  return median(seconds);
}

/// Timed entries, fastest first.
std::vector<const RaceEntry*> ranking(const RaceResult& result) {
  std::vector<const RaceEntry*> timed;
  for (const RaceEntry& entry : result.entries)
    if (entry.state == State::timed) timed.push_back(&entry);
  std::stable_sort(timed.begin(), timed.end(), [](const RaceEntry* a, const RaceEntry* b) {
    return median_of(*a, &PhaseSeconds::total) < median_of(*b, &PhaseSeconds::total);
  });
  return timed;
}

ordered_json workload_json(const Workload& workload, const RaceResult& result) {
  const GrowthParameters& growth = workload.seedling.growth;
  return {
      {"name", workload.name},
      {"points", workload.seedling.attraction_points.size()},
      {"iterations", growth.iterations},
      {"executed_iterations", result.iterations},
      {"nodes", result.nodes},
      {"seed", workload.seed},
      {"density", workload.density},
      {"influence_distance", growth.influence_distance},
      {"judge", result.judge},
      {"floor",
       {{"association_pairs", result.floor.association}, {"removal_pairs", result.floor.removal}}}};
}

void put_work(ordered_json& json, const RaceEntry& entry, const PairFloor& least) {
  json["distance_evaluations"] = evaluations(entry);
  const std::uint64_t floor = least.association + least.removal;
  if (floor > 0)
    json["evaluations_over_floor"] =
        static_cast<double>(evaluations(entry)) / static_cast<double>(floor);
  json["work"] = {{"search_evaluations", entry.work.search_evaluations},
                  {"kill_evaluations", entry.work.kill_evaluations},
                  {"cells_visited", entry.work.cells_visited},
                  {"index_updates", entry.work.index_updates},
                  {"queries", entry.work.queries}};
}

/// A plugin that failed its trial: no lane, and so no option and no threads.
ordered_json failed_json(const TriedPlugin& plugin) {
  ordered_json json{{"name", plugin.verdict.engine},
                    {"options", nullptr},
                    {"threads", nullptr},
                    {"state", "failed trial"},
                    {"built", true},
                    {"exact", nullptr},
                    {"tree_hash", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr},
                    {"distance_evaluations", nullptr},
                    {"bytes_per_point", nullptr},
                    {"phases", nullptr}};
  if (plugin.verdict.engine.empty()) json["name"] = nullptr;  // it ended before it told
  if (plugin.verdict.kind == PluginVerdict::Kind::wrong) json["exact"] = false;
  put_plugin(json, plugin);
  return json;
}

/// `plugin` is null for engines of the program. What a plugin computes is not known.
ordered_json entry_json(const RaceEntry& entry, const RaceResult& result,
                        const TriedPlugin* plugin) {
  ordered_json json{{"name", entry.engine->name},
                    {"options", entry.option},
                    {"threads", entry.threads},
                    {"state", name_of(entry.state)},
                    {"built", entry.engine->built()},
                    {"exact", nullptr},
                    {"tree_hash", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr},
                    {"distance_evaluations", nullptr},
                    {"bytes_per_point", nullptr},
                    {"phases", nullptr}};
  if (plugin != nullptr) put_plugin(json, *plugin);
  if (entry.predicted_s > 0.0) json["predicted_s"] = entry.predicted_s;
  if (entry.state == State::not_built) json["missing_package"] = entry.engine->missing_package;
  if (entry.state == State::inexact) {
    json["exact"] = false;
    json["disagreement"] = entry.disagreement;
  }
  if (entry.state != State::timed) return json;
  json["exact"] = true;
  json["tree_hash"] = entry.tree_hash;
  put_seconds(json, total_of(entry));
  if (entry.bytes_per_point >= 0.0) json["bytes_per_point"] = entry.bytes_per_point;
  if (plugin == nullptr) put_work(json, entry, result.floor);
  json["phases"] = {{"build_s", median_reset(entry)},
                    {"search_s", median_of(entry, &PhaseSeconds::association)},
                    {"kill_s", median_of(entry, &PhaseSeconds::kill)},
                    {"growth_s", median_of(entry, &PhaseSeconds::growth)}};
  return json;
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
                   [](const RaceEntry& entry) { return entry.state == State::timed; });
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

ordered_json document(const Workload& workload, const RaceResult& result,
                      const std::vector<ApproximateEntry>& approximate,
                      const NearestNodeRaceOptions& options,
                      const std::vector<TriedPlugin>& plugins) {
  ordered_json json;
  json["schema"] = "phytobench/race-1";
  json["workload"] = workload_json(workload, result);
  json["engines"] = ordered_json::array();
  for (const RaceEntry& entry : result.entries)
    json["engines"].push_back(entry_json(entry, result, exact_plugin(plugins, entry.engine->name)));
  for (const TriedPlugin& plugin : plugins)
    if (!plugin.verdict.is_exact()) json["engines"].push_back(failed_json(plugin));
  json["ratios"] = ordered_json::array();
  const auto ranked = ranking(result);
  for (std::size_t i = 1; i < ranked.size(); ++i)
    json["ratios"].push_back(
        ratio_json(ranked[i]->name(), ranked[0]->name(), ratio_of(*ranked[i], *ranked[0])));
  json["approximate"] = approximate_json(approximate, options.threads.front());
  json["environment"] = ordered_json::parse(
      environment_json(options.command_line, workload.seed,
                       *std::max_element(options.threads.begin(), options.threads.end())));
  return json;
}

/// Pairs looked at, as a multiple of those that must be; "?" for a plugin, which does not count.
std::string pairs_in_words(const RaceEntry& entry, const PairFloor& least, bool is_counted) {
  if (!is_counted) return "?";
  const auto floor = static_cast<double>(least.association + least.removal);
  return fmt::format("{:.3g}", floor > 0.0 ? static_cast<double>(evaluations(entry)) / floor : 0.0);
}

std::string timed_line(const RaceEntry& entry, const RaceEntry& fastest, const RaceResult& result,
                       const std::vector<TriedPlugin>& plugins) {
  const MedianOfRounds total = total_of(entry), ratio = ratio_of(entry, fastest);
  return fmt::format(
      "{:<29} {:>10}  {:>10} - {:>10}  {:>8.1f}x  {:>10} {:>10} {:>10} {:>10}  {:>9} {:>7}\n",
      entry.name(), with_unit(total.value), with_unit(total.low), with_unit(total.high),
      ratio.value, with_unit(median_reset(entry)),
      with_unit(median_of(entry, &PhaseSeconds::association)),
      with_unit(median_of(entry, &PhaseSeconds::kill)),
      with_unit(median_of(entry, &PhaseSeconds::growth)),
      pairs_in_words(entry, result.floor, exact_plugin(plugins, entry.engine->name) == nullptr),
      entry.bytes_per_point < 0.0 ? "?" : fmt::format("{:.1f}", entry.bytes_per_point));
}

std::string other_line(const RaceEntry& entry) {
  switch (entry.state) {
    case State::not_built:
      return fmt::format("{:<29} not built: {} was not found\n", entry.name(),
                         entry.engine->missing_package);
    case State::skipped:
      return fmt::format("{:<29} skipped: predicted {} for one growth, more than --budget\n",
                         entry.name(), with_unit(entry.predicted_s));
    case State::inexact:
      return fmt::format("{:<29} INEXACT, no time: {}\n", entry.name(), entry.disagreement);
    case State::timed:
      break;
  }
  return {};
}

std::string table(const Workload& workload, const RaceResult& result,
                  const std::vector<TriedPlugin>& plugins) {
  std::string text = fmt::format(
      "{}: {} points, {} iterations, {} nodes\njudged by the {}; pairs that must be "
      "looked at: {} to associate, {} to remove\n\n",
      workload.name, workload.seedling.attraction_points.size(), result.iterations, result.nodes,
      result.judge, result.floor.association, result.floor.removal);
  const auto ranked = ranking(result);
  const EndsInWords ends = ends_in_words(ranked.empty() ? 0 : ranked.front()->rounds.size());
  if (!ranked.empty())
    text += fmt::format(
        "{:<29} {:>10}  {:>10} - {:>10}  {:>9}  {:>10} {:>10} {:>10} {:>10}  {:>9} {:>7}\n",
        "engine, option", "median", ends.from, "to", "fastest", "build", "search", "kill", "growth",
        "pairs/min", "B/point");
  for (const RaceEntry* entry : ranked)
    text += timed_line(*entry, *ranked.front(), result, plugins);
  for (const RaceEntry& entry : result.entries) text += other_line(entry);
  return text + failed_lines(plugins) + ends.note;
}

/// Races and fills `text` with what is to be printed; returns the exit code.
int race_into(std::string& text, const NearestNodeRaceOptions& options,
              const std::vector<TriedPlugin>& plugins, PluginPulse& pulse) {
  keep_freed_memory();
  auto engines = chosen_engines(options.engines);
  const auto loop_options = chosen_options(options.options);
  const Workload workload = chosen_workload(options);
  const auto loaded = load_exact(plugins, pulse);
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
  text = options.json ? document(workload, result, approximate, options, plugins).dump(2) + "\n"
                      : table(workload, result, plugins) + approximate_table(approximate);
  const bool wrong = std::any_of(result.entries.begin(), result.entries.end(),
                                 [](const RaceEntry& e) { return e.state == State::inexact; });
  return wrong || !all_exact(plugins) ? 1 : 0;
}

/// Everything that could start a thread happens in the child.
int race_with_plugins(const NearestNodeRaceOptions& options) {
  const SupervisionLimits limits{.silence_s = options.plugin_limit,
                                 .is_interrupted = is_interrupted};
  const auto plugins = try_plugins(options.plugins, limits);
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
