// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/overlap/overlap_race.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_document.hpp"
#include "cli/race_numbers.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/overlap/discs_file.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;
using OverlapState = OverlapEntry::State;

std::vector<OverlapContestant> chosen_contestants(const OverlapRaceOptions& options) {
  std::vector<OverlapContestant> chosen;
  const auto add = [&](const OverlapEngineDescriptor& engine) {
    for (const int threads : options.threads) chosen.push_back({&engine, threads});
  };
  for (const std::string& name : options.engines) {
    const auto engines = all_overlap_engines();
    const auto found = std::find_if(engines.begin(), engines.end(),
                                    [&](const auto* engine) { return engine->name == name; });
    if (name == "all")
      for (const OverlapEngineDescriptor* engine : engines) add(*engine);
    else if (found != engines.end())
      add(**found);
    else
      throw InputError("unknown engine '" + name + "'; known: all, " +
                       known_overlap_engine_names());
  }
  // Only ours knows threads: another one is there once.
  std::vector<OverlapContestant> once;
  for (const OverlapContestant& c : chosen)
    if (c.threads == options.threads.front() || c.engine->uses_threads) once.push_back(c);
  for (OverlapContestant& c : once)
    if (!c.engine->uses_threads) c.threads = 1;
  return once;
}

OverlapWorkload chosen_workload(const OverlapRaceOptions& options) {
  if (!options.window.empty() && (options.discs.empty() || !options.torus))
    throw InputError("--window says which torus your --discs lie on; give --torus and --discs too");
  if (options.discs.empty())
    return random_discs({.count = static_cast<std::size_t>(std::llround(options.size)),
                         .sizes = disc_sizes_named(options.sizes),
                         .partners = options.partners,
                         .is_torus = options.torus,
                         .seed = options.seed});
  if (options.torus && options.window.empty())
    throw InputError("--torus with --discs needs --window x0,y0,x1,y1");
  OverlapWorkload workload;
  if (options.torus) workload.ground.torus = rectangle_from(options.window, "--window");
  DiscTable table = read_discs(options.discs, workload.ground, usual_radius_column(options.discs));
  workload.name = options.discs;
  workload.seed = options.seed;
  workload.x = std::move(table.x);
  workload.y = std::move(table.y);
  workload.radius = std::move(table.radius);
  return workload;
}

const char* name_of(OverlapState state) {
  switch (state) {
    case OverlapState::timed:
      return "timed";
    case OverlapState::inexact:
      return "inexact";
    case OverlapState::skipped:
      return "skipped";
    case OverlapState::not_built:
      return "not built";
  }
  return "";
}

/// Timed entries, fastest first.
std::vector<const OverlapEntry*> ranking(const OverlapRaceResult& result) {
  std::vector<const OverlapEntry*> timed;
  for (const OverlapEntry& entry : result.entries)
    if (entry.state == OverlapState::timed) timed.push_back(&entry);
  std::stable_sort(timed.begin(), timed.end(), [](const auto* a, const auto* b) {
    return median(a->seconds) < median(b->seconds);
  });
  return timed;
}

ordered_json entry_json(const OverlapEntry& entry) {
  ordered_json json{{"name", entry.engine->name},
                    {"options", ""},
                    {"threads", entry.threads},
                    {"state", name_of(entry.state)},
                    {"built", entry.engine->built()},
                    {"exact", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr},
                    {"distance_evaluations", nullptr}};
  if (entry.predicted_s > 0.0) json["predicted_s"] = entry.predicted_s;
  if (entry.state == OverlapState::not_built)
    json["missing_package"] = entry.engine->missing_package;
  if (entry.state == OverlapState::inexact) {
    json["exact"] = false;
    json["disagreement"] = entry.disagreement;
  }
  if (entry.state != OverlapState::timed) return json;
  json["exact"] = true;
  put_seconds(json, median_of_rounds(entry.seconds));
  json["distance_evaluations"] = entry.work.candidates;
  return json;
}

ordered_json document(const OverlapWorkload& workload, const OverlapRaceResult& result,
                      const OverlapRaceOptions& options) {
  ordered_json json = race_document({{"name", workload.name},
                                     {"discs", workload.x.size()},
                                     {"pairs", result.pairs},
                                     {"torus", workload.ground.torus.has_value()},
                                     {"seed", workload.seed},
                                     {"judge", result.judge},
                                     {"largest_area_error", result.largest_area_error}});
  for (const OverlapEntry& entry : result.entries) json["engines"].push_back(entry_json(entry));
  const auto ranked = ranking(result);
  for (std::size_t i = 1; i < ranked.size(); ++i)
    json["ratios"].push_back(ratio_json(ranked[i]->name(), ranked[0]->name(),
                                        ratio_of_rounds(ranked[i]->seconds, ranked[0]->seconds)));
  json["lens"] = ordered_json::array();
  for (const LensEntry& lens : result.lens) {
    ordered_json alone{{"name", lens.name}};
    put_seconds(alone, median_of_rounds(lens.seconds));
    json["lens"].push_back(std::move(alone));
    if (lens.name != "vector")
      json["ratios"].push_back(
          ratio_json("lens " + lens.name, "lens vector",
                     ratio_of_rounds(lens.seconds, result.lens.back().seconds)));
  }
  put_environment(json, options.command_line, workload.seed, options.threads);
  return json;
}

std::string timed_line(const std::string& name, const std::vector<double>& seconds,
                       const std::vector<double>& fastest, const std::string& work) {
  const MedianOfRounds total = median_of_rounds(seconds);
  const MedianOfRounds ratio = ratio_of_rounds(seconds, fastest);
  return fmt::format("{:<27} {:>10}  {:>10} - {:>10}  {:>7.2f}x [{:.2f}, {:.2f}]  {}\n", name,
                     with_unit(total.value), with_unit(total.low), with_unit(total.high),
                     ratio.value, ratio.low, ratio.high, work);
}

std::string other_line(const OverlapEntry& entry) {
  switch (entry.state) {
    case OverlapState::not_built:
      return fmt::format("{:<27} not built: {} was not found\n", entry.name(),
                         entry.engine->missing_package);
    case OverlapState::skipped:
      return fmt::format("{:<27} skipped: predicted {} for one search, more than --budget\n",
                         entry.name(), with_unit(entry.predicted_s));
    case OverlapState::inexact:
      return fmt::format("{:<27} INEXACT, no time: {}\n", entry.name(), entry.disagreement);
    case OverlapState::timed:
      break;
  }
  return {};
}

std::string heading_with(const EndsInWords& ends) {
  return fmt::format("{:>10}  {:>10} - {:>10}  {:>8} {:<14}", "median", ends.from, "to", "fastest",
                     ends.ratio);
}

/// Areas of all pairs, without the search for them.
std::string lens_table(const std::vector<LensEntry>& lens, const EndsInWords& ends) {
  std::string text = fmt::format("\n{:<27} {}\n", "areas alone", heading_with(ends));
  for (const LensEntry& entry : lens)
    text += timed_line(entry.name, entry.seconds, lens.back().seconds, "");
  return text;
}

std::string table(const OverlapWorkload& workload, const OverlapRaceResult& result) {
  std::string text = fmt::format(
      "{}: {} overlapping pairs\njudged by the {}; areas of a sample are right to {:.1e}\n\n",
      workload.name, result.pairs, result.judge, result.largest_area_error);
  const auto ranked = ranking(result);
  const EndsInWords ends = ends_in_words(ranked.empty() ? 0 : ranked.front()->seconds.size());
  if (!ranked.empty())
    text += fmt::format("{:<27} {}  looked at/pair\n", "engine", heading_with(ends));
  for (const OverlapEntry* entry : ranked)
    text += timed_line(entry->name(), entry->seconds, ranked.front()->seconds,
                       result.pairs == 0
                           ? ""
                           : fmt::format("{:.3g}", static_cast<double>(entry->work.candidates) /
                                                       static_cast<double>(result.pairs)));
  for (const OverlapEntry& entry : result.entries) text += other_line(entry);
  if (result.lens.empty()) return text + ends.note;
  const EndsInWords lens_ends = ends_in_words(result.lens.front().seconds.size());
  text += lens_table(result.lens, lens_ends);
  // Once: it explains "least" and "most", in whichever heading they stand.
  return text + (ends.note.empty() ? lens_ends.note : ends.note);
}

}  // namespace

int race_overlap(const OverlapRaceOptions& options) {
  keep_freed_memory();
  const auto contestants = chosen_contestants(options);
  const OverlapWorkload workload = chosen_workload(options);
  catch_interrupts();
  const OverlapRaceResult result = phytobench::race_overlap({.workload = &workload,
                                                             .contestants = contestants,
                                                             .budget_s = options.budget,
                                                             .rounds = options.rounds,
                                                             .order_seed = options.seed,
                                                             .show_progress = show_progress,
                                                             .is_interrupted = is_interrupted});
  print(options.json ? json_text(document(workload, result, options)) + "\n"
                     : table(workload, result));
  const bool wrong =
      std::any_of(result.entries.begin(), result.entries.end(),
                  [](const OverlapEntry& e) { return e.state == OverlapState::inexact; });
  return wrong ? 1 : 0;
}

}  // namespace phytobench::cli
