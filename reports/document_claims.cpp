// SPDX-License-Identifier: MIT
#include "reports/document_claims.hpp"

#include <algorithm>
#include <regex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_agreement.hpp"
#include "reports/document_anchors.hpp"
#include "reports/document_locators.hpp"
#include "reports/document_measured.hpp"
#include "reports/expectation.hpp"
#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string outcome_word(CheckOutcome outcome) {
  switch (outcome) {
    case CheckOutcome::holds:
      return "holds";
    case CheckOutcome::fails:
      return "fails";
    case CheckOutcome::undecided:
      return "undecided";
    case CheckOutcome::missing:
      return "not measured";
  }
  return "";
}

/// The first term of a check says what all of its terms must meet.
ordered_json check_part(const JudgedCheck& check) {
  ordered_json row{{"wanted", check.wanted},
                   {"why", check.why},
                   {"result", outcome_word(check.outcome)},
                   {"term_count", check.terms.size()},
                   {"several", check.terms.size() > 1},
                   {"terms", ordered_json::array()}};
  const bool alike = std::all_of(check.terms.begin(), check.terms.end(),
                                 [&](const auto& term) { return term.outcome == check.outcome; });
  row["alike"] = alike;
  row["mixed"] = !alike;
  for (const JudgedTerm& term : check.terms)
    row["terms"].push_back({{"expression", shown_expression(term)},
                            {"measured", term.measured},
                            {"outcome", outcome_word(term.outcome)},
                            {"first", row["terms"].empty()}});
  return row;
}

/// Whether a value stands with its interval, which readers must be told.
bool rests_on_intervals(const Judgement& judgement) {
  for (const JudgedCheck& check : judgement.checks)
    for (const JudgedTerm& term : check.terms)
      if (term.measured.find(" [") != std::string::npos) return true;
  return false;
}

std::string search_tokens(const std::string& locator) {
  std::string tokens;
  for (const Place& place : places_of(locator)) {
    const std::string token = search_token(place);
    if (!token.empty()) tokens += (tokens.empty() ? "" : " ") + token;
  }
  return tokens;
}

void add_text(ordered_json& part, const std::string& key, const std::string& text) {
  part[key] = text;
  part["has_" + key] = !text.empty();
}

void add_prediction(ordered_json& part, const Judgement& judgement, bool hidden) {
  const Claim& claim = *judgement.claim;
  const auto predicted = claim.predicted_verdict;
  add_text(part, "predicted", predicted ? std::string(label_of(*predicted)) : "");
  part["differs"] = predicted && !hidden && !lacks_evidence(judgement) &&
                    claim.missing_model.empty() && judgement.verdict != Verdict::inconclusive &&
                    judgement.verdict != *predicted;
  const bool as_predicted =
      predicted && !hidden && judgement.verdict == *predicted && claim.difference.empty();
  part["as_predicted"] = as_predicted;
  part["shows_prediction"] = predicted && !as_predicted;
  add_text(part, "difference", claim.difference);
  add_text(part, "machine_dependence", claim.machine_dependence);
  add_text(part, "missing_model", claim.missing_model);
}

void add_repeat(ordered_json& part, const Claim& claim, const ClaimContext& context) {
  const std::vector<std::string> experiments = experiments_of(claim);
  const CostOfRepeat cost = context.costs.of(experiments, claim.tier);
  part["has_repeat"] = !experiments.empty();
  part["repeat"] = repeat_experiments(experiments, claim.tier, context.seed);
  add_text(part, "time", cost.time);
  add_text(part, "memory", cost.memory);
  part["cost_varies"] = cost.varies;
}

void add_assumptions(ordered_json& part, const Claim& claim, const ClaimContext& context) {
  part["assumptions"] = ordered_json::array();
  const auto found = context.assumptions.find(claim.id);
  if (found != context.assumptions.end())
    for (const std::string& id : found->second)
      part["assumptions"].push_back({{"id", id}, {"anchor", assumption_anchor(claim.paper, id)}});
  part["has_assumptions"] = !part["assumptions"].empty();
}

}  // namespace

std::string published_with_unit(const Claim& claim) {
  const std::string &published = claim.published, &unit = claim.unit;
  // "5200", "-1.9" or "0.1 to 0.4", but no formula and no words.
  static const std::regex bare("[-+0-9., ]+( to [-+0-9., ]+)?");
  if (unit.empty() || unit == "1" || !std::regex_match(published, bare) || published == "-")
    return published;
  const bool several_degrees = unit == "degree" && published != "1";
  return published + " " + unit + (several_degrees ? "s" : "");
}

std::string verdict_class(Verdict verdict) {
  return slug(name_of(verdict));
}

std::string row_class(const VerdictRow& row) {
  return row.name == fitted_row ? "fitted" : verdict_class(row.verdict);
}

ShownVerdict shown_verdict(const Judgement& judgement, bool without_varying) {
  if (without_varying && judgement.varies)
    return {left_out_row, left_out_class, left_out_class, true};
  const VerdictRow& row = row_of(judgement);
  return {std::string(row.name), row_class(row), slug(row.identifier), false};
}

ordered_json claim_brief(const Judgement& judgement, bool without_varying) {
  const Claim& claim = *judgement.claim;
  const ShownVerdict shown = shown_verdict(judgement, without_varying);
  ordered_json part;
  part["id"] = claim.id;
  part["short_id"] = short_claim_id(claim.id);
  part["anchor"] = claim_anchor(claim.id);
  part["locator"] = claim.locator;
  part["text"] = claim.text;
  const std::string published = claim.published == "-" ? "" : claim.published;
  add_text(part, "published", published);
  part["unit"] = claim.unit == "1" ? "" : claim.unit;
  part["published_text"] = published.empty() ? "" : published_with_unit(claim);
  part["verdict"] = shown.hidden ? left_out_row : name_of(judgement.verdict);
  part["label"] = shown.label;
  part["class"] = shown.look;
  part["row"] = shown.row;
  part["reason"] = judgement.reason;
  part["varies"] = judgement.varies;
  const Expectation expectation = expectation_of(judgement);
  part["unexpected"] = !shown.hidden && expectation == Expectation::unexpected;
  part["by_machine"] = !shown.hidden && expectation == Expectation::depends_on_machine;
  part["expected"] = label_of(claim.expected_verdict);
  add_prediction(part, judgement, shown.hidden);
  return part;
}

ordered_json claim_document(const Judgement& judgement, const ClaimContext& context) {
  const Claim& claim = *judgement.claim;
  ordered_json part = claim_brief(judgement, context.without_varying);
  const bool hidden = shown_verdict(judgement, context.without_varying).hidden;
  part["kind"] = claim.kind;
  part["basis"] = claim.basis;
  part["tier"] = name_of(claim.tier);
  part["places"] = search_tokens(claim.locator);
  add_text(part, "erratum", claim.erratum);
  part["erratum_anchor"] = erratum_anchor(claim.paper, claim.erratum);
  add_assumptions(part, claim, context);
  add_text(part, "measured", hidden ? left_out_row : shown_measured(judgement));
  const std::string agreement = shown_agreement(claim, context.evidence);
  add_text(part, "agreement", judgement.contradicted ? "" : agreement);  // it is of one run only
  add_repeat(part, claim, context);
  part["checks"] = ordered_json::array();
  if (!hidden)
    for (const JudgedCheck& check : judgement.checks) part["checks"].push_back(check_part(check));
  part["has_checks"] = !part["checks"].empty();
  part["has_intervals"] = !hidden && rests_on_intervals(judgement);
  part["shows_intervals"] = part["measured"].get<std::string>().find(" [") != std::string::npos;
  return part;
}

ordered_json claim_problems(const Judgement& judgement) {
  ordered_json problems = ordered_json::array();
  for (const JudgedCheck& check : judgement.checks) {
    if (check.outcome == CheckOutcome::holds) continue;
    for (const JudgedTerm& term : check.terms)
      if (term.outcome != CheckOutcome::holds)
        problems.push_back({{"expression", shown_expression(term)},
                            {"measured", term.measured},
                            {"outcome", outcome_word(term.outcome)},
                            {"wanted", check.wanted}});
  }
  return problems;
}

}  // namespace phytobench
