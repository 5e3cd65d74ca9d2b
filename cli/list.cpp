// SPDX-License-Identifier: MIT
#include <cctype>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/component_list.hpp"
#include "cli/terminal.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "experiments/experiment_registry.hpp"
#include "reference/graph_presets.hpp"
#include "reference/lesser2019_switches.hpp"
#include "reference/lsystem_presets.hpp"
#include "reference/papers.hpp"
#include "reference/site_presets.hpp"
#include "reference/stand_presets.hpp"
#include "reference/tree_presets.hpp"
#include "reports/claim_list.hpp"
#include "reports/errata_list.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

ordered_json papers() {
  ordered_json rows = ordered_json::array();
  for (const std::string& key : paper_keys()) {
    const Paper paper = load_paper(key);
    rows.push_back({{"id", paper.key},
                    {"title", paper.title},
                    {"author", paper.author},
                    {"year", paper.year},
                    {"kind", paper.kind},
                    {"summary", paper.summary}});
  }
  return rows;
}

ordered_json claims() {
  ordered_json rows = ordered_json::array();
  for (const ListedClaim& claim : listed_claims())
    rows.push_back({{"id", claim.id},
                    {"kind", claim.kind},
                    {"locator", claim.locator},
                    {"tier", claim.tier},
                    {"summary", claim.text}});
  return rows;
}

/// Of all papers; which of them `terrain --as-printed` can leave in is said, too.
ordered_json errata() {
  ordered_json rows = ordered_json::array();
  for (const ListedErratum& erratum : listed_errata()) {
    std::string id = erratum.paper + "/" + erratum.id;
    for (char& c : id) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    rows.push_back({{"id", id},
                    {"locator", erratum.locator},
                    {"printed", erratum.printed},
                    {"corrected", erratum.corrected},
                    {"consequence", erratum.consequence},
                    {"as_printed", erratum.paper == "lesser2019" && can_be_left_in(erratum.id)},
                    {"summary", fmt::format("{}: {}; {}: {}", erratum.locator, erratum.printed,
                                            erratum.is_of_program ? "the program" : "corrected",
                                            erratum.corrected)}});
  }
  return rows;
}

ordered_json experiments() {
  ordered_json rows = ordered_json::array();
  for (const ExperimentDescriptor* experiment : all_experiments())
    rows.push_back({{"id", experiment->id},
                    {"source", experiment->source},
                    {"seconds",
                     {{"smoke", experiment->seconds[0]},
                      {"quick", experiment->seconds[1]},
                      {"full", experiment->seconds[2]}}},
                    {"summary", experiment->question}});
  return rows;
}

ordered_json engines() {
  ordered_json rows = ordered_json::array();
  for (const EngineDescriptor* engine : all_engines())
    rows.push_back({{"id", engine->name},
                    {"source", engine->source},
                    {"built", engine->built()},
                    {"missing_package", engine->missing_package},
                    {"uses_option_n", engine->uses_point_filter},
                    {"summary", engine->summary}});
  return rows;
}

ordered_json overlap_engines() {
  ordered_json rows = ordered_json::array();
  for (const OverlapEngineDescriptor* engine : all_overlap_engines())
    rows.push_back({{"id", engine->name},
                    {"source", engine->source},
                    {"built", engine->built()},
                    {"missing_package", engine->missing_package},
                    {"uses_threads", engine->uses_threads},
                    {"summary", engine->summary}});
  return rows;
}

ordered_json preset_rows(const std::vector<PresetFile>& presets) {
  ordered_json rows = ordered_json::array();
  for (const PresetFile& preset : presets)
    rows.push_back(
        {{"id", preset.name}, {"file", preset.file.string()}, {"summary", preset.summary}});
  return rows;
}

ordered_json presets() {
  ordered_json rows = preset_rows(tree_presets());
  for (const GraphPreset& preset : graph_presets())
    rows.push_back({{"id", preset.name},
                    {"file", preset.file.string()},
                    {"summary", "components: " + preset.summary}});
  return rows;
}

ordered_json graphs() {
  return preset_rows(graph_presets());
}

ordered_json lsystems() {
  return preset_rows(lsystem_presets());
}

ordered_json stands() {
  return preset_rows(stand_presets());
}

ordered_json sites() {
  return preset_rows(site_presets());
}

ordered_json site_entries() {
  return preset_rows(site_entry_files());
}

ordered_json shadow_engines() {
  ordered_json rows = ordered_json::array();
  for (const ShadowEngineDescriptor* engine : all_shadow_engines())
    rows.push_back({{"id", engine->name},
                    {"source", engine->source},
                    {"built", engine->built()},
                    {"missing_package", engine->missing_package},
                    {"exact", engine->exact},
                    {"summary", engine->summary}});
  return rows;
}

ordered_json rules() {
  ordered_json rows = ordered_json::array();
  for (const CompetitionRuleDescriptor* rule : all_competition_rules())
    rows.push_back({{"id", rule->name},
                    {"source", rule->source},
                    {"built", rule->built()},
                    {"missing_package", rule->missing_package},
                    {"uses_below", rule->uses_below},
                    {"uses_above", rule->uses_above},
                    {"summary", rule->summary}});
  return rows;
}

struct Kind {
  const char* name;
  ordered_json (*rows)();
};
constexpr Kind kinds[] = {{"papers", papers},
                          {"claims", claims},
                          {"errata", errata},
                          {"experiments", experiments},
                          {"engines", engines},
                          {"overlap-engines", overlap_engines},
                          {"presets", presets},
                          {"graphs", graphs},
                          {"components", component_rows},
                          {"lsystems", lsystems},
                          {"stands", stands},
                          {"sites", sites},
                          {"site-entries", site_entries},
                          {"shadow-engines", shadow_engines},
                          {"rules", rules}};

std::string plain(const ordered_json& rows) {
  std::string text;
  std::size_t width = 0;
  for (const ordered_json& row : rows) width = std::max(width, row["id"].get<std::string>().size());
  for (const ordered_json& row : rows) {
    const bool missing = row.contains("built") && !row["built"].get<bool>();
    text += fmt::format(
        "{:<{}}  {}{}\n", row["id"].get<std::string>(), width,
        missing ? "[not built: " + row["missing_package"].get<std::string>() + "] " : "",
        row["summary"].get<std::string>());
  }
  return text;
}

ordered_json overview() {
  ordered_json rows = ordered_json::array();
  for (const Kind& kind : kinds)
    rows.push_back({{"id", kind.name}, {"summary", std::to_string(kind.rows().size())}});
  return rows;
}

ordered_json rows_of(const std::string& what) {
  if (what.empty()) return overview();
  std::vector<std::string> names;
  for (const Kind& kind : kinds) {
    if (what == kind.name) return kind.rows();
    names.emplace_back(kind.name);
  }
  throw InputError(fmt::format("cannot list '{}'{}; use one of {}", what, did_you_mean(what, names),
                               fmt::join(names, ", ")));
}

}  // namespace

int list(const ListOptions& options) {
  const ordered_json rows = rows_of(options.what);
  if (!options.json) {
    print(plain(rows));
    return 0;
  }
  ordered_json document;
  document["schema"] = "phytobench/list-1";
  document["kind"] = options.what.empty() ? "overview" : options.what;
  document["entries"] = rows;
  print(document.dump(2) + "\n");
  return 0;
}

}  // namespace phytobench::cli
