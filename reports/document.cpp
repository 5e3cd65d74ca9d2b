// SPDX-License-Identifier: MIT
#include "reports/document.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "build_information.hpp"
#include "reports/compact_svg.hpp"
#include "reports/document_attention.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_papers.hpp"
#include "reports/document_part.hpp"
#include "reports/document_predictions.hpp"
#include "reports/document_provenance.hpp"
#include "reports/document_repeat.hpp"
#include "reports/document_scaling.hpp"
#include "reports/document_summary.hpp"
#include "reports/document_timings.hpp"
#include "reports/document_unclaimed.hpp"
#include "reports/run_limits.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// What tells each of several runs from the others; nothing of a single run.
ordered_json merged_runs(const RunComparison* comparison) {
  ordered_json runs = ordered_json::array();
  if (!comparison) return runs;
  for (const ComparedRun& run : comparison->runs)
    runs.push_back({{"letter", run_letter(runs.size())},
                    {"label", run.label},
                    {"tier", name_of(run.contents.header.tier)},
                    {"seed", run.contents.header.seed}});
  return runs;
}

ordered_json run_part(const JudgedRun& judged, const DocumentSources& sources,
                      const ordered_json& environment) {
  const bool without_varying = sources.without_varying;
  const ClaimCounts counts = counts_of(judged, without_varying);
  ordered_json part{{"tier", name_of(judged.run.header.tier)},
                    {"seed", judged.run.header.seed},
                    {"experiments", judged.run.complete_experiments.size()},
                    {"measurements", judged.run.records.size()},
                    {"timings", without_varying ? 0 : judged.run.timings.size()},
                    {"version", build_information::version},
                    {"claims", counts.claims},
                    {"measured_claims", counts.measured},
                    {"reproduced", counts.reproduced},
                    {"fitted", counts.fitted},
                    {"errata", counts.with_erratum},
                    {"refuted", counts.refuted},
                    {"inconclusive", counts.inconclusive},
                    {"unexpected", counts.unexpected},
                    {"hidden", counts.hidden},
                    {"verdicts_vary", counts.vary && !without_varying},
                    {"has_varying", !without_varying}};
  const std::size_t decided =
      counts.reproduced + counts.fitted + counts.with_erratum + counts.refuted;
  part["decided"] = decided;
  part["open"] = counts.claims - decided - counts.hidden;
  part["runs"] = merged_runs(sources.comparison);
  part["several"] = sources.comparison != nullptr;
  part["run_count"] = part["runs"].size();
  part["one_with_varying"] = !without_varying && !sources.comparison;
  if (without_varying) return part;
  part["date"] = environment.value("date_utc", "unknown date");
  part["run_version"] = environment.value("suite_version", "unknown");
  part["commit"] = environment.value("commit", "unknown");
  part["source_changed"] = environment.value("source_changed", false);
  return part;
}

/// Works of which something was run first, and each in the order of the judged run.
ordered_json papers_part(const JudgedRun& judged, const PaperSources& sources) {
  ordered_json papers = ordered_json::array();
  for (const bool in_run : {true, false})
    for (const JudgedPaper& paper : judged.papers)
      if (is_in_run(judged.run, paper.paper.key) == in_run)
        papers.push_back(paper_document(paper, sources));
  return papers;
}

/// What was asked and found, after what keeps the run from telling all of it; and at last which
/// verdicts are neither the expected ones nor unexpected.
ordered_json first_lines(const JudgedRun& judged, const DocumentSources& sources) {
  const bool without_varying = sources.without_varying;
  ordered_json lines = summary_document(judged, sources.comparison, without_varying);
  const auto line = [](const char* term, const std::string& text, bool varies) {
    return ordered_json{{"term", term}, {"text", text}, {"varies", varies}};
  };
  if (const std::string text = incompleteness(judged); !text.empty())
    lines.insert(lines.begin(), line("Incomplete", text, false));
  const ordered_json by_machine = machine_dependent(judged, without_varying);
  if (by_machine.empty()) return lines;
  std::string names;
  for (const ordered_json& claim : by_machine)
    names += (names.empty() ? "" : ", ") + claim["short_id"].get<std::string>();
  const std::string count = counted(by_machine.size(), "verdict is", "verdicts are");
  lines.push_back(
      line("Machines",
           fmt::format("{} not as expected, but known to depend on the machine; such verdicts "
                       "count neither as expected nor as unexpected: {}.",
                       count, names),
           true));
  return lines;
}

std::size_t total_count(const ordered_json& parts) {
  std::size_t total = 0;
  for (const ordered_json& part : parts) total += part["count"].get<std::size_t>();
  return total;
}

ordered_json studies_part(const JudgedRun& judged, const DocumentSources& sources) {
  ordered_json studies = ordered_json::array();
  if (judged.scaling.measured())
    studies.push_back(scaling_document(judged.scaling, sources.plots, sources.without_varying));
  return studies;
}

/// Pictures in the page need not be as they are in their files.
void compact_pictures(ordered_json& part) {
  for (auto& [key, value] : part.items()) {
    if (key == "svg" && value.is_string())
      value = compact_svg(value.get<std::string>());
    else if (value.is_structured())
      compact_pictures(value);
  }
}

/// Where the times come from.
std::string times_line(const ordered_json& environment, const RunComparison* comparison) {
  return comparison ? "The times of each experiment are of the first run that completed it."
                    : machine_line(environment);
}

}  // namespace

ordered_json make_document(const JudgedRun& judged, const DocumentSources& sources) {
  const bool without_varying = sources.without_varying;
  const auto environment = ordered_json::parse(sources.environment_json);
  const Evidence evidence(judged.run);
  const ExperimentCosts costs(judged.run, sources.experiments, without_varying);
  ordered_json document;
  document["run"] = run_part(judged, sources, environment);
  document["summary"] = first_lines(judged, sources);
  document["counts"] = counts_document(judged, without_varying);
  add_part(document, "attention", attention_document(judged, without_varying));
  document["predictions"] = predictions_document(judged, without_varying);
  document["papers"] = papers_part(judged, {judged.run,
                                            evidence,
                                            costs,
                                            {sources.pictures, sources.plot_data, sources.captions},
                                            sources.photographs,
                                            without_varying});
  add_part(document, "studies", studies_part(judged, sources));
  compact_pictures(document);
  document["timing"] = timings_document(judged.run, without_varying);
  document["timing"]["machine"] =
      without_varying ? "" : times_line(environment, sources.comparison);
  add_part(document, "environment",
           without_varying ? ordered_json::array() : environment_rows(environment));
  document["limits"] = run_limits(judged, without_varying);
  document["repeat"] = repeat_document(judged, costs, sources.comparison);
  add_part(document, "unclaimed_groups", unclaimed_document(judged, without_varying));
  document["unclaimed"] = total_count(document["unclaimed_groups"]);
  for (const char* slot : {"comparison", "validation"})
    document[std::string("has_") + slot] = false;
  return document;
}

}  // namespace phytobench
