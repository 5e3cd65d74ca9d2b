// SPDX-License-Identifier: MIT
#include "reports/document_claims.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr const char* left_out = "left out: rests on times";

/// A text usable as a CSS class or an anchor.
std::string slug(std::string text) {
  for (char& c : text)
    if (c == ' ' || c == '/' || c == '.') c = '-';
  return text;
}

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

/// The experiments whose measurements a claim is judged on.
std::vector<std::string> experiments_of(const Claim& claim) {
  std::vector<std::string> experiments;
  for (const ClaimCheck& check : claim.checks)
    for (const auto& term : check.terms)
      for (const std::string& part : term) {
        const std::size_t start = check.subject == CheckSubject::sum ? 1 : 0;
        const std::size_t second = part.find('/', part.find('/') + 1);
        const std::string id = part.substr(start, second - start);
        if (std::find(experiments.begin(), experiments.end(), id) == experiments.end())
          experiments.push_back(id);
      }
  return experiments;
}

ordered_json checks_part(const Judgement& judgement) {
  ordered_json checks = ordered_json::array();
  for (const JudgedCheck& check : judgement.checks) {
    ordered_json row{
        {"wanted", check.wanted}, {"why", check.why}, {"outcome", outcome_word(check.outcome)}};
    for (const JudgedTerm& term : check.terms)
      row["terms"].push_back({{"expression", term.expression},
                              {"measured", term.measured},
                              {"outcome", outcome_word(term.outcome)}});
    checks.push_back(row);
  }
  return checks;
}

/// The terms that keep a claim from holding.
ordered_json problems_part(const Judgement& judgement) {
  ordered_json problems = ordered_json::array();
  for (const JudgedCheck& check : judgement.checks) {
    if (check.outcome == CheckOutcome::holds) continue;
    for (const JudgedTerm& term : check.terms)
      if (term.outcome != CheckOutcome::holds)
        problems.push_back({{"expression", term.expression},
                            {"measured", term.measured},
                            {"outcome", outcome_word(term.outcome)},
                            {"wanted", check.wanted}});
  }
  return problems;
}

}  // namespace

std::string verdict_class(Verdict verdict) {
  return slug(std::string(name_of(verdict)));
}

ordered_json claim_document(const Judgement& judgement, bool hidden) {
  const Claim& claim = *judgement.claim;
  ordered_json part;
  part["id"] = claim.id;
  part["anchor"] = slug(claim.id);
  part["locator"] = claim.locator;
  part["kind"] = claim.kind;
  part["text"] = claim.text;
  part["published"] = claim.published;
  part["unit"] = claim.unit == "1" ? "" : claim.unit;
  part["basis"] = claim.basis;
  part["erratum"] = claim.erratum;
  part["has_erratum"] = !claim.erratum.empty();
  part["varies"] = judgement.varies;
  part["verdict"] = hidden ? left_out : name_of(judgement.verdict);
  part["class"] = verdict_class(hidden ? Verdict::not_measured : judgement.verdict);
  part["measured"] = hidden ? left_out : judgement.measured;
  part["has_measured"] = !part["measured"].get<std::string>().empty();
  part["reason"] = judgement.reason;
  part["unexpected"] = !hidden && judgement.is_unexpected();
  part["expected"] = name_of(claim.expected_verdict);
  part["has_repeat"] = !claim.checks.empty();
  part["repeat"] = repeat_experiments(experiments_of(claim), claim.tier);
  part["checks"] = hidden ? ordered_json::array() : checks_part(judgement);
  part["problems"] = hidden ? ordered_json::array() : problems_part(judgement);
  return part;
}

}  // namespace phytobench
