// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "cli/race_approximate.hpp"
#include "cli/race_document.hpp"
#include "cli/race_nearest_node_numbers.hpp"
#include "cli/race_nearest_node_output.hpp"
#include "cli/race_numbers.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;
using NearestNodeState = RaceEntry::State;

const char* name_of(NearestNodeState state) {
  switch (state) {
    case NearestNodeState::timed:
      return "timed";
    case NearestNodeState::inexact:
      return "inexact";
    case NearestNodeState::skipped:
      return "skipped";
    case NearestNodeState::not_built:
      return "not built";
  }
  return "";
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

/// A plugin that got no time: no lane, and so no option and no threads.
ordered_json failed_json(const TriedPlugin& plugin) {
  ordered_json json{{"name", plugin.verdict.engine},
                    {"options", nullptr},
                    {"threads", nullptr},
                    {"state", plugin.verdict.is_exact() ? "failed race" : "failed trial"},
                    {"built", true},
                    {"exact", nullptr},
                    {"tree_hash", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr},
                    {"distance_evaluations", nullptr},
                    {"bytes_per_point", nullptr},
                    {"phases", nullptr}};
  if (plugin.verdict.engine.empty()) json["name"] = nullptr;  // it ended before it told
  if (plugin.failure().kind == PluginVerdict::Kind::wrong) json["exact"] = false;
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
  if (entry.state == NearestNodeState::not_built)
    json["missing_package"] = entry.engine->missing_package;
  if (entry.state == NearestNodeState::inexact) {
    json["exact"] = false;
    json["disagreement"] = entry.disagreement;
  }
  if (entry.state != NearestNodeState::timed) return json;
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

ordered_json document(const NearestNodeRaceOutcome& outcome) {
  const auto& [options, workload, result, approximate, plugins] = outcome;
  ordered_json json = race_document(workload_json(workload, result));
  for (const RaceEntry& entry : result.entries)
    json["engines"].push_back(entry_json(entry, result, raced_plugin(plugins, entry.engine->name)));
  for (const TriedPlugin& plugin : plugins)
    if (!plugin.is_raced()) json["engines"].push_back(failed_json(plugin));
  const auto ranked = ranking(result);
  for (std::size_t i = 1; i < ranked.size(); ++i)
    json["ratios"].push_back(
        ratio_json(ranked[i]->name(), ranked[0]->name(), ratio_of(*ranked[i], *ranked[0])));
  json["approximate"] = approximate_json(approximate, options.threads.front());
  put_environment(json, options.command_line, workload.seed, options.threads);
  return json;
}

}  // namespace

std::string nearest_node_race_json(const NearestNodeRaceOutcome& outcome) {
  return document(outcome).dump(2) + "\n";
}

}  // namespace phytobench::cli
