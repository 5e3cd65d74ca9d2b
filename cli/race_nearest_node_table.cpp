// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/option_values.hpp"
#include "cli/race_approximate.hpp"
#include "cli/race_nearest_node_numbers.hpp"
#include "cli/race_nearest_node_output.hpp"
#include "cli/race_numbers.hpp"

namespace phytobench::cli {

namespace {

using NearestNodeState = RaceEntry::State;

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
      pairs_in_words(entry, result.floor, raced_plugin(plugins, entry.engine->name) == nullptr),
      entry.bytes_per_point < 0.0 ? "?" : fmt::format("{:.1f}", entry.bytes_per_point));
}

std::string other_line(const RaceEntry& entry) {
  switch (entry.state) {
    case NearestNodeState::not_built:
      return fmt::format("{:<29} not built: {} was not found\n", entry.name(),
                         entry.engine->missing_package);
    case NearestNodeState::skipped:
      return fmt::format("{:<29} skipped: predicted {} for one growth, more than --budget\n",
                         entry.name(), with_unit(entry.predicted_s));
    case NearestNodeState::inexact:
      return fmt::format("{:<29} INEXACT, no time: {}\n", entry.name(), entry.disagreement);
    case NearestNodeState::timed:
      break;
  }
  return {};
}

}  // namespace

std::string nearest_node_race_table(const NearestNodeRaceOutcome& outcome) {
  const auto& [options, workload, result, approximate, plugins] = outcome;
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
  return text + failed_lines(plugins) + ends.note + approximate_table(approximate);
}

}  // namespace phytobench::cli
