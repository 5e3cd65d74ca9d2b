// SPDX-License-Identifier: MIT
// The judge: a pure function from a claim and the evidence to a verdict. It never runs a model and
// never reads a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/claims.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

enum class CheckOutcome { holds, fails, undecided, missing };

/// One term of a check with what was found.
struct JudgedTerm {
  std::string expression;  ///< "squared.s/seconds / binary.s/seconds"
  std::string measured;    ///< "1.91 [1.88, 1.95]"
  CheckOutcome outcome = CheckOutcome::missing;
  std::optional<MedianOfRounds> number = std::nullopt;  ///< what the bounds decided on, if a number
};

struct JudgedCheck {
  std::string wanted;  ///< ">= 1.2 in 4 of 4"
  std::string why;
  CheckOutcome outcome = CheckOutcome::missing;
  std::vector<JudgedTerm> terms;
};

struct Judgement {
  const Claim* claim = nullptr;
  Verdict verdict = Verdict::not_measured;
  std::string measured;  ///< short text for tables; the checks hold all of it
  std::string reason;    ///< the claim's own, or why nothing could be measured
  std::vector<JudgedCheck> checks;
  bool varies = false;  ///< rests on times, which differ between equal runs
  /// Several runs decided it differently: inconclusive, for no lack of evidence.
  bool contradicted = false;

  /// Whether the verdict contradicts the claim's expected one. Missing evidence and noise
  /// contradict nothing, nor do times where they are known to come out otherwise elsewhere.
  bool is_unexpected() const;
};

Judgement judge(const Claim& claim, const Evidence& evidence, Tier tier);

}  // namespace phytobench
