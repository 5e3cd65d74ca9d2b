// SPDX-License-Identifier: MIT
#include "reports/verdict_counts.hpp"

#include <algorithm>

namespace phytobench {

bool is_fitted(const Judgement& judgement) {
  return judgement.verdict == Verdict::reproduced && judgement.claim->basis == "fitted";
}

bool has_measurement(const Judgement& judgement) {
  return std::any_of(judgement.checks.begin(), judgement.checks.end(), [](const auto& check) {
    return std::any_of(check.terms.begin(), check.terms.end(),
                       [](const auto& term) { return term.outcome != CheckOutcome::missing; });
  });
}

}  // namespace phytobench
