// SPDX-License-Identifier: MIT
#include "cli/race_shadow_output.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/option_values.hpp"
#include "cli/race_document.hpp"
#include "cli/race_numbers.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;
using ShadowState = ShadowEntry::State;

/// "1024 x 1024 about 3 h on one core", of 13 hours of daylight ([Lesser2019] sec. 9.2.2, p. 38).
constexpr double printed_rays_per_second = 13.0 * 1024 * 1024 / (3 * 3600);

const char* shadow_state_name(ShadowState state) {
  switch (state) {
    case ShadowState::timed:
      return "timed";
    case ShadowState::wrong:
      return "wrong";
    case ShadowState::skipped:
      return "skipped";
    case ShadowState::not_built:
      return "not built";
  }
  return "";
}

double shadow_rate(const ShadowEntry& entry, const ShadowWorkload& workload) {
  return static_cast<double>(workload.vertex_hours()) / median(entry.seconds);
}

/// Timed entries, fastest first.
std::vector<const ShadowEntry*> ranked_shadows(const ShadowRaceResult& result) {
  std::vector<const ShadowEntry*> timed;
  for (const ShadowEntry& entry : result.entries)
    if (entry.state == ShadowState::timed) timed.push_back(&entry);
  std::stable_sort(timed.begin(), timed.end(), [](const auto* a, const auto* b) {
    return median(a->seconds) < median(b->seconds);
  });
  return timed;
}

/// What all are compared with: the first timed exact_traversal, if there is one.
const ShadowEntry* exact_traversal_of(const ShadowRaceResult& result) {
  for (const ShadowEntry& entry : result.entries)
    if (entry.state == ShadowState::timed && entry.engine->name == "exact_traversal") return &entry;
  return nullptr;
}

void put_shadow_times(ordered_json& json, const ShadowEntry& entry,
                      const ShadowWorkload& workload) {
  const double rate = shadow_rate(entry, workload);
  put_seconds(json, median_of_rounds(entry.seconds));
  json["vertex_hours_per_second_and_thread"] = rate / entry.threads;
  json["factor_over_printed_rate"] = rate / printed_rays_per_second;
}

ordered_json shadow_entry_json(const ShadowEntry& entry, const ShadowWorkload& workload) {
  ordered_json json{{"name", entry.engine->name},
                    {"options", ""},
                    {"threads", entry.threads},
                    {"state", shadow_state_name(entry.state)},
                    {"built", entry.engine->built()},
                    {"exact", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr}};
  if (entry.predicted_s > 0.0) json["predicted_s"] = entry.predicted_s;
  if (entry.state == ShadowState::not_built)
    json["missing_package"] = entry.engine->missing_package;
  if (entry.state == ShadowState::wrong) {
    json["exact"] = false;
    json["disagreement"] = entry.disagreement;
  }
  if (entry.state != ShadowState::timed) return json;
  json["exact"] = entry.engine->exact;
  json["wrong_share"] = entry.wrong_share;
  put_shadow_times(json, entry, workload);
  json["peak_bytes"] = nullptr;
  if (entry.bytes) json["peak_bytes"] = *entry.bytes;
  json["samples"] = entry.work.samples;
  json["blocks"] = entry.work.blocks;
  json["rays"] = entry.work.rays;
  json["stuck"] = entry.work.stuck;
  return json;
}

std::string peak_text(const ShadowEntry& entry) {
  return entry.bytes ? fmt::format("{:.1f} MiB", static_cast<double>(*entry.bytes) / 1048576.0)
                     : "unknown";
}

std::string timed_shadow_line(const ShadowEntry& entry, const ShadowEntry* exact,
                              const ShadowWorkload& workload) {
  const MedianOfRounds total = median_of_rounds(entry.seconds);
  std::string ratio;
  if (exact != nullptr) {
    const MedianOfRounds faster = ratio_of_rounds(exact->seconds, entry.seconds);
    ratio = fmt::format("{:.2f}x [{:.2f}, {:.2f}]", faster.value, faster.low, faster.high);
  }
  const double rate = shadow_rate(entry, workload);
  return fmt::format(
      "{:<27} {:>10}  {:>10} - {:>10}  {:>24}  {:>9.2f}  {:>10.3g}  {:>11}  {}\n", entry.name(),
      with_unit(total.value), with_unit(total.low), with_unit(total.high), ratio,
      rate / entry.threads / 1e6, rate / printed_rays_per_second, peak_text(entry),
      entry.engine->exact ? "exact" : fmt::format("{:.4f} %", 100.0 * entry.wrong_share));
}

std::string untimed_shadow_line(const ShadowEntry& entry) {
  switch (entry.state) {
    case ShadowState::not_built:
      return fmt::format("{:<27} not built: {} was not found\n", entry.name(),
                         entry.engine->missing_package);
    case ShadowState::skipped:
      return fmt::format("{:<27} skipped: predicted {} for all hours, more than --budget\n",
                         entry.name(), with_unit(entry.predicted_s));
    case ShadowState::wrong:
      return fmt::format("{:<27} WRONG, no time: {}\n", entry.name(), entry.disagreement);
    case ShadowState::timed:
      break;
  }
  return {};
}

double terrain_bytes(const ShadowWorkload& workload) {
  return static_cast<double>(workload.field.size() * sizeof(double));
}

}  // namespace

ordered_json shadow_race_document(const ShadowRaceReport& report,
                                  const ShadowRaceOptions& options) {
  const ShadowWorkload& workload = *report.workload;
  ordered_json json = race_document({{"name", workload.name},
                                     {"columns", workload.field.columns()},
                                     {"rows", workload.field.rows()},
                                     {"hours", workload.suns.size()},
                                     {"vertex_hours", workload.vertex_hours()},
                                     {"lit", report.result->lit},
                                     {"terrain_bytes", terrain_bytes(workload)},
                                     {"seed", options.seed},
                                     {"judge", report.result->judge},
                                     {"left_out", report.left_out}});
  for (const ShadowEntry& entry : report.result->entries)
    json["engines"].push_back(shadow_entry_json(entry, workload));
  // Each against exact_traversal, the slower one first.
  const ShadowEntry* exact = exact_traversal_of(*report.result);
  for (const ShadowEntry* entry : ranked_shadows(*report.result)) {
    if (exact == nullptr || entry == exact) continue;
    const bool is_faster = median(entry->seconds) <= median(exact->seconds);
    const ShadowEntry &slow = is_faster ? *exact : *entry, &fast = is_faster ? *entry : *exact;
    json["ratios"].push_back(
        ratio_json(slow.name(), fast.name(), ratio_of_rounds(slow.seconds, fast.seconds)));
  }
  put_environment(json, options.command_line, options.seed, options.threads);
  return json;
}

std::string shadow_race_table(const ShadowRaceReport& report) {
  const ShadowWorkload& workload = *report.workload;
  std::string text = fmt::format(
      "{}, {} hours: {:.2f} % of {} vertex-hours in the sun\njudged by {}; the terrain takes "
      "{:.1f} MiB\n\n",
      workload.name, workload.suns.size(),
      100.0 * static_cast<double>(report.result->lit) /
          static_cast<double>(workload.vertex_hours()),
      workload.vertex_hours(), report.result->judge, terrain_bytes(workload) / 1048576.0);
  const auto timed = ranked_shadows(*report.result);
  const EndsInWords ends = ends_in_words(timed.empty() ? 0 : timed.front()->seconds.size());
  if (!timed.empty())
    text += fmt::format("{:<27} {:>10}  {:>10} - {:>10}  {:>24}  {:>9}  {:>10}  {:>11}  {}\n",
                        "engine", "median", ends.from, "to", "exact/this, " + ends.ratio,
                        "M/s/thread", "x printed", "peak", "wrong");
  const ShadowEntry* exact = exact_traversal_of(*report.result);
  for (const ShadowEntry* entry : timed) text += timed_shadow_line(*entry, exact, workload);
  for (const ShadowEntry& entry : report.result->entries) text += untimed_shadow_line(entry);
  for (const std::string& name : report.left_out)
    text +=
        fmt::format("{:<27} left out on so large a map; name it in --engines to have it\n", name);
  return text + ends.note;
}

}  // namespace phytobench::cli
