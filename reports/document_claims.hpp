// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_costs.hpp"
#include "reports/judge/judge.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

/// The row of a claim whose verdict is hidden.
inline constexpr const char* left_out_row = "left out: rests on times";
inline constexpr const char* left_out_class = "left-out";

/// A verdict as a report shows it: the row in which it is counted, as words and as CSS classes.
struct ShownVerdict {
  std::string label;    ///< "reproduced, fitted"
  std::string look;     ///< class of its colour: "fitted"
  std::string row;      ///< class of the row, by its identifier: "reproduced-fitted"
  bool hidden = false;  ///< it rests on times, and those are left out
};

ShownVerdict shown_verdict(const Judgement& judgement, bool without_varying);

/// The published text with its unit, unless the text names that itself or is "-".
std::string published_with_unit(const Claim& claim);

/// A verdict, or the row in which it is counted, as a CSS class.
std::string verdict_class(Verdict verdict);
std::string row_class(const VerdictRow& row);

/// What the texts on a claim rest on besides its judgement.
struct ClaimContext {
  const Evidence& evidence;
  const ExperimentCosts& costs;
  bool without_varying = false;
  std::uint64_t seed = 0;
  std::map<std::string, std::vector<std::string>> assumptions;  ///< their ids by full claim id
};

/// What a list says about a claim: verdict, place, text, published value and anchor.
nlohmann::ordered_json claim_brief(const Judgement& judgement, bool without_varying);

/// Everything a report says about one claim. A hidden one keeps only what does not vary.
nlohmann::ordered_json claim_document(const Judgement& judgement, const ClaimContext& context);

/// The terms that keep a claim from holding.
nlohmann::ordered_json claim_problems(const Judgement& judgement);

}  // namespace phytobench
