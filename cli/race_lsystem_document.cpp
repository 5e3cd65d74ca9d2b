// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "cli/race_document.hpp"
#include "cli/race_lsystem_output.hpp"
#include "cli/race_numbers.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;
using DrawingState = DrawingEntry::State;

const char* name_of(DrawingState state) {
  switch (state) {
    case DrawingState::timed:
      return "timed";
    case DrawingState::wrong:
      return "wrong";
    case DrawingState::refused:
      return "refused";
    case DrawingState::not_built:
      return "not built";
  }
  return "";
}

ordered_json system_json(const LSystemWorkload& workload, const DrawingRaceResult& result) {
  return {{"name", workload.name},
          {"derivations", workload.steps},
          {"segments", workload.segments},
          {"modules", workload.modules},
          {"planar", result.planar},
          {"bound", result.bound},
          {"bytes_per_segment", segment_bytes(result)}};
}

ordered_json entry_json(const DrawingEntry& entry, const LSystemWorkload& workload) {
  ordered_json json{{"name", entry.engine->name},
                    {"system", workload.name},
                    {"lane", phytobench::name_of(entry.lane)},
                    {"threads", entry.threads},
                    {"state", name_of(entry.state)},
                    {"built", entry.engine->built()},
                    {"exact", nullptr},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr}};
  if (entry.state == DrawingState::not_built)
    json["missing_package"] = entry.engine->missing_package;
  if (entry.state == DrawingState::refused) json["objection"] = entry.objection;
  if (entry.state == DrawingState::wrong) {
    json["exact"] = false;
    json["disagreement"] = entry.objection;
  }
  if (entry.state != DrawingState::timed) return json;
  json["exact"] = true;
  const MedianOfRounds seconds = median_of_rounds(entry.seconds);
  put_seconds(json, seconds);
  json["segments_per_s"] = static_cast<double>(workload.segments) / seconds.value;
  json["modules_per_s"] = static_cast<double>(workload.modules) / seconds.value;
  json["bytes_held"] = entry.bytes_held;
  return json;
}

ordered_json derivation_json(const DerivationEntry& entry) {
  ordered_json json{{"name", entry.name},
                    {"derivations", entry.steps},
                    {"threads", entry.threads},
                    {"exact", entry.objection.empty()},
                    {"modules", entry.modules},
                    {"every_word", entry.every_word},
                    {"modules_made", entry.modules_made},
                    {"bytes_per_module", entry.bytes_per_module},
                    {"median_s", nullptr},
                    {"ci95_s", nullptr}};
  if (!entry.objection.empty()) json["disagreement"] = entry.objection;
  if (entry.seconds.empty()) return json;
  const MedianOfRounds seconds = median_of_rounds(entry.seconds);
  put_seconds(json, seconds);
  json["modules_per_s"] = static_cast<double>(entry.modules_made) / seconds.value;
  return json;
}

}  // namespace

ordered_json lsystem_document(const LSystemRaceResults& results,
                              const LSystemRaceOptions& options) {
  ordered_json json = race_document({{"name", "L-systems without parameters, derived and drawn"},
                                     {"most_segments", options.segments},
                                     {"seed", options.seed},
                                     {"systems", ordered_json::array()}});
  for (const char* part : {"means", "derivations"}) json[part] = ordered_json::array();
  for (std::size_t s = 0; s < results.drawings.size(); ++s) {
    const DrawingRaceResult& result = results.drawings[s];
    json["workload"]["systems"].push_back(system_json(results.workloads[s], result));
    for (const DrawingEntry& entry : result.entries) {
      json["engines"].push_back(entry_json(entry, results.workloads[s]));
      const DrawingEntry* const base = baseline_of(result, entry);
      if (base == nullptr || base == &entry || entry.state != DrawingState::timed) continue;
      ordered_json ratio = ratio_json(full_name(*base), full_name(entry),
                                      ratio_of_rounds(base->seconds, entry.seconds));
      ratio["system"] = results.workloads[s].name;
      ratio["lane"] = phytobench::name_of(entry.lane);
      json["ratios"].push_back(std::move(ratio));
    }
  }
  for (std::size_t e = 0; e < results.drawings.front().entries.size(); ++e) {
    const DrawingEntry& entry = results.drawings.front().entries[e];
    if (const auto ns = mean_ns(results, e))
      json["means"].push_back({{"name", entry.engine->name},
                               {"lane", phytobench::name_of(entry.lane)},
                               {"threads", entry.threads},
                               {"ns_per_segment", *ns}});
  }
  for (const DerivationEntry& entry : results.derivations)
    json["derivations"].push_back(derivation_json(entry));
  put_environment(json, options.command_line, options.seed, options.threads);
  return json;
}

}  // namespace phytobench::cli
