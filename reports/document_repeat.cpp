// SPDX-License-Identifier: MIT
#include "reports/document_repeat.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_numbers.hpp"
#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

ordered_json experiment_row(const std::string& experiment, const JudgedRun& judged,
                            const ExperimentCosts& costs, std::size_t claims) {
  const RunHeader& header = judged.run.header;
  const CostOfRepeat cost = costs.of({experiment}, header.tier);
  const auto facts = costs.facts().find(experiment);
  const std::string question = facts == costs.facts().end() ? "" : facts->second.question;
  return {{"id", experiment},
          {"anchor", experiment_anchor(experiment)},
          {"question", question},
          {"has_question", !question.empty()},
          {"command", repeat_experiments({experiment}, header.tier, header.seed)},
          {"claim_count", claims},
          {"in_run", judged.run.complete_experiments.contains(experiment)},
          {"time", cost.time.empty() ? "not known" : cost.time},
          {"memory", cost.memory.empty() ? "not recorded" : cost.memory},
          {"varies", cost.varies}};
}

/// No names where a run holds every experiment that the program knows.
std::vector<std::string> selection_of(const RunContents& run, const ExperimentCosts& costs) {
  const auto& known = costs.facts();
  const bool is_whole =
      !known.empty() && std::all_of(known.begin(), known.end(), [&](const auto& experiment) {
        return run.complete_experiments.contains(experiment.first);
      });
  if (is_whole) return {};
  return {run.complete_experiments.begin(), run.complete_experiments.end()};
}

/// The commands that make all runs again, and the report of them.
ordered_json whole_runs(const std::vector<const RunContents*>& runs, const ExperimentCosts& costs) {
  ordered_json commands = ordered_json::array();
  std::string report = "phytobench report";
  for (const RunContents* run : runs) {
    std::string folder = "results/again";
    if (runs.size() > 1) folder += fmt::format("-{}", commands.size() + 1);
    commands.push_back(repeat_run(selection_of(*run, costs), run->header, folder));
    report += " " + folder;
  }
  return {{"runs", commands}, {"report", report}};
}

}  // namespace

ordered_json repeat_document(const JudgedRun& judged, const ExperimentCosts& costs,
                             const RunComparison* comparison) {
  std::map<std::string, std::size_t> claims;
  for (const std::string& experiment : judged.run.complete_experiments) claims[experiment] = 0;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      for (const std::string& experiment : experiments_of(*judgement.claim)) ++claims[experiment];
  std::vector<const RunContents*> runs{&judged.run};
  if (comparison) {
    runs.clear();
    for (const ComparedRun& run : comparison->runs) runs.push_back(&run.contents);
  }
  ordered_json document = whole_runs(runs, costs);
  document["has_total"] = costs.measured_seconds() > 0.0;
  document["total"] = rough_seconds(costs.measured_seconds());
  document["experiments"] = ordered_json::array();
  for (const auto& [experiment, count] : claims)
    document["experiments"].push_back(experiment_row(experiment, judged, costs, count));
  return document;
}

}  // namespace phytobench
