// SPDX-License-Identifier: MIT
#include "reports/verdicts_json.hpp"

#include <nlohmann/json.hpp>

#include "reports/expectation.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

ordered_json text_or_null(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json claim_row(const Judgement& judgement) {
  const Claim& claim = *judgement.claim;
  return {{"id", claim.id},
          {"verdict", name_of(judgement.verdict)},
          {"row", row_of(judgement).identifier},
          {"basis", claim.basis},
          {"published", claim.published},
          {"measured", judgement.measured},
          {"expected", name_of(claim.expected_verdict)},
          {"predicted", claim.predicted_verdict ? ordered_json(name_of(*claim.predicted_verdict))
                                                : ordered_json(nullptr)},
          {"unexpected", judgement.is_unexpected()},
          {"expectation", name_of(expectation_of(judgement))},
          {"machine_dependence", text_or_null(claim.machine_dependence)},
          {"digits", claim.digits ? ordered_json(*claim.digits) : ordered_json(nullptr)},
          {"unit", claim.unit},
          {"kind", claim.kind},
          {"topic", claim.topic},
          {"locator", claim.locator},
          {"tier", name_of(claim.tier)},
          {"erratum", text_or_null(claim.erratum)},
          {"varies", judgement.varies},
          {"reason", judgement.reason}};
}

/// What each run says of one claim.
ordered_json by_run(const ComparedClaim& claim) {
  ordered_json rows = ordered_json::array();
  for (std::size_t run = 0; run < claim.verdicts.size(); ++run)
    rows.push_back({{"run", run},
                    {"verdict", name_of(claim.verdicts[run])},
                    {"measured", claim.measured[run]}});
  return rows;
}

ordered_json runs_of(const RunComparison& comparison) {
  ordered_json rows = ordered_json::array();
  for (const ComparedRun& run : comparison.runs)
    rows.push_back({{"letter", run_letter(rows.size())},
                    {"label", run.label},
                    {"tier", name_of(run.contents.header.tier)},
                    {"seed", run.contents.header.seed}});
  return rows;
}

}  // namespace

std::string verdicts_json(const JudgedRun& judged, const RunComparison* comparison,
                          bool without_varying) {
  ordered_json json;
  json["schema"] = "phytobench/verdicts-1";
  json["tier"] = name_of(judged.run.header.tier);
  json["seed"] = judged.run.header.seed;
  if (comparison) json["runs"] = runs_of(*comparison);
  json["claims"] = ordered_json::array();
  std::size_t place = 0;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      const std::size_t own = place++;
      if (without_varying && judgement.varies) continue;
      json["claims"].push_back(claim_row(judgement));
      if (comparison) json["claims"].back()["by_run"] = by_run(comparison->claims[own]);
    }
  return json.dump(2) + "\n";
}

}  // namespace phytobench
