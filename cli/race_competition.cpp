// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/competition/step_race.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_document.hpp"
#include "cli/race_numbers.hpp"
#include "cli/terminal.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/power_law.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

std::vector<StepContestant> chosen_contestants(const CompetitionRaceOptions& options) {
  std::vector<StepContestant> chosen;
  const auto add = [&](const CompetitionRuleDescriptor& rule) {
    for (const int threads : options.threads) chosen.push_back({&rule, threads});
  };
  for (const std::string& name : options.rules) {
    if (name != "all") {
      add(competition_rule_named(name));
      continue;
    }
    for (const CompetitionRuleDescriptor* rule : all_competition_rules())
      if (rule->built()) add(*rule);
  }
  return chosen;
}

/// Entries of one size.
struct SizeResult {
  std::int64_t plants;
  std::vector<StepEntry> entries;
};

std::vector<SizeResult> race_all_sizes(const CompetitionRaceOptions& options) {
  std::vector<SizeResult> results;
  for (const double size : options.plants) {
    const std::int64_t plants = std::llround(size);
    const auto tell = [plants](const std::string& what) {
      show_progress(fmt::format("{} plants: {}", plants, what));
    };
    results.push_back({plants, race_steps({.plants = plants,
                                           .pairs_per_plant = options.pairs,
                                           .contestants = chosen_contestants(options),
                                           .rounds = options.rounds,
                                           .seed = options.seed,
                                           .show_progress = tell,
                                           .is_interrupted = is_interrupted})});
  }
  return results;
}

ordered_json estimate_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"ci95", {estimate.low, estimate.high}}};
}

ordered_json entry_json(const StepEntry& entry, std::int64_t plants) {
  ordered_json json{{"name", entry.rule->name}, {"threads", entry.threads},
                    {"plants", plants},         {"exact", entry.objection.empty()},
                    {"median_s", nullptr},      {"ci95_s", nullptr}};
  if (!entry.objection.empty()) json["disagreement"] = entry.objection;
  if (entry.seconds.empty()) return json;
  const MedianOfRounds seconds = median_of_rounds(entry.seconds);
  put_seconds(json, seconds);
  json["plants_per_s"] = static_cast<double>(plants) / seconds.value;
  json["pairs"] = entry.pairs;
  json["search_s"] =
      entry.search.empty() ? ordered_json(nullptr) : ordered_json(median(entry.search));
  json["bytes_per_plant"] =
      entry.bytes_per_plant > 0.0 ? ordered_json(entry.bytes_per_plant) : ordered_json(nullptr);
  return json;
}

/// How time grows with the number of plants: for three sizes or more.
std::optional<PowerLaw> growth_of_time(const std::vector<SizeResult>& results, std::size_t entry) {
  std::vector<double> plants, seconds;
  for (const SizeResult& size : results) {
    if (size.entries[entry].seconds.empty()) return std::nullopt;
    plants.push_back(static_cast<double>(size.plants));
    seconds.push_back(median(size.entries[entry].seconds));
  }
  return fit_power_law(plants, seconds);
}

/// The entry of the same rule on one thread, if there is one.
const StepEntry* on_one_thread(const SizeResult& size, const StepEntry& entry) {
  for (const StepEntry& other : size.entries)
    if (other.rule == entry.rule && other.threads == 1 && !other.seconds.empty()) return &other;
  return nullptr;
}

ordered_json document(const std::vector<SizeResult>& results,
                      const CompetitionRaceOptions& options) {
  ordered_json json = race_document({{"name", "one step of plants of two sizes on a torus"},
                                     {"plants", ordered_json::array()},
                                     {"pairs_per_plant", options.pairs},
                                     {"seed", options.seed}});
  json["exponents"] = ordered_json::array();
  for (const SizeResult& size : results) {
    json["workload"]["plants"].push_back(size.plants);
    for (const StepEntry& entry : size.entries) {
      json["engines"].push_back(entry_json(entry, size.plants));
      const StepEntry* one = on_one_thread(size, entry);
      if (one == nullptr || one == &entry || entry.seconds.empty()) continue;
      const MedianOfRounds gain = ratio_of_rounds(one->seconds, entry.seconds);
      ordered_json ratio = estimate_json(gain);
      ratio["rounds"] = gain.rounds;
      ratio["name"] = entry.rule->name;
      ratio["plants"] = size.plants;
      ratio["threads"] = entry.threads;
      json["ratios"].push_back(ratio);
    }
  }
  for (std::size_t e = 0; e < results.front().entries.size(); ++e) {
    const auto law = growth_of_time(results, e);
    if (!law) continue;
    ordered_json exponent = estimate_json(law->exponent);
    exponent["name"] = results.front().entries[e].rule->name;
    exponent["threads"] = results.front().entries[e].threads;
    json["exponents"].push_back(exponent);
  }
  put_environment(json, options.command_line, options.seed, options.threads);
  return json;
}

std::string row_of(const SizeResult& size, const StepEntry& entry) {
  if (!entry.objection.empty())
    return fmt::format("{:<24}{:>8}  WRONG, no time: {}\n", entry.rule->name, entry.threads,
                       entry.objection);
  const MedianOfRounds s = median_of_rounds(entry.seconds);
  const StepEntry* one = on_one_thread(size, entry);
  std::string ratio;
  if (one != nullptr && one != &entry) {
    const MedianOfRounds r = ratio_of_rounds(one->seconds, entry.seconds);
    ratio = fmt::format("  {:.2f}x [{:.2f}, {:.2f}] of one thread", r.value, r.low, r.high);
  }
  return fmt::format(
      "{:<24}{:>8}{:>11}{:>11}{:>11}{:>9.2f}{:>11}{:>9}{}\n", entry.rule->name, entry.threads,
      with_unit(s.value), with_unit(s.low), with_unit(s.high),
      static_cast<double>(size.plants) / s.value / 1e6,
      entry.search.empty() ? "-" : with_unit(median(entry.search)),
      entry.bytes_per_plant > 0.0 ? fmt::format("{:.0f}", entry.bytes_per_plant) : "-", ratio);
}

std::string table(const std::vector<SizeResult>& results, const CompetitionRaceOptions& options) {
  std::string text;
  const EndsInWords ends = ends_in_words(static_cast<std::size_t>(options.rounds));
  for (const SizeResult& size : results) {
    text += fmt::format(
        "{} plants of two sizes on a torus, {:g} overlapping pairs of root zones a plant\n\n"
        "{:<24}{:>8}{:>11}{:>11}{:>11}{:>9}{:>11}{:>9}\n{:<24}{:>8}{:>11}{:>11}{:>11}{:>9}{:>11}"
        "{:>9}\n",
        size.plants, options.pairs, "rule", "threads", "one step", ends.from, "to", "million",
        "search", "bytes", "", "", "", "", "", "a second", "alone", "a plant");
    for (const StepEntry& entry : size.entries) text += row_of(size, entry);
    text += "\n";
  }
  for (std::size_t e = 0; e < results.front().entries.size(); ++e)
    if (const auto law = growth_of_time(results, e))
      text += fmt::format("{:<24}{:>8}  time grows as plants^{:.3f} [{:.3f}, {:.3f}]\n",
                          results.front().entries[e].rule->name, results.front().entries[e].threads,
                          law->exponent.value, law->exponent.low, law->exponent.high);
  return text + ends.note;
}

}  // namespace

int race_competition(const CompetitionRaceOptions& options) {
  keep_freed_memory();
  catch_interrupts();
  const std::vector<SizeResult> results = race_all_sizes(options);
  print(options.json ? document(results, options).dump(2) + "\n" : table(results, options));
  for (const SizeResult& size : results)
    for (const StepEntry& entry : size.entries)
      if (!entry.objection.empty()) return 1;
  return 0;
}

}  // namespace phytobench::cli
