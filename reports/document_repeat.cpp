// SPDX-License-Identifier: MIT
#include "reports/document_repeat.hpp"

#include <map>

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
  const ExperimentCost cost = costs.of({experiment}, header.tier);
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

}  // namespace

ordered_json repeat_document(const JudgedRun& judged, const ExperimentCosts& costs,
                             const std::string& command_line) {
  std::map<std::string, std::size_t> claims;
  for (const std::string& experiment : judged.run.complete_experiments) claims[experiment] = 0;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      for (const std::string& experiment : experiments_of(*judgement.claim)) ++claims[experiment];
  const RunHeader& header = judged.run.header;
  ordered_json document{{"run", repeat_run(selection_of(command_line), header.tier, header.seed)},
                        {"report", "phytobench report results/again"},
                        {"has_total", costs.measured_seconds() > 0.0},
                        {"total", rough_seconds(costs.measured_seconds())},
                        {"experiments", ordered_json::array()}};
  for (const auto& [experiment, count] : claims)
    document["experiments"].push_back(experiment_row(experiment, judged, costs, count));
  return document;
}

}  // namespace phytobench
