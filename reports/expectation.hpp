// SPDX-License-Identifier: MIT
// How a verdict stands to the one that this version of the suite expects.
#pragma once

#include <string_view>

#include "reports/judge/judge.hpp"

namespace phytobench {

enum class Expectation {
  met,
  unexpected,          ///< otherwise, and nothing explains it
  depends_on_machine,  ///< otherwise, but times of the claim are known to come out so elsewhere
  undecided,           ///< not measured or inconclusive: nothing to compare
};

inline Expectation expectation_of(const Judgement& judgement) {
  if (judgement.verdict == judgement.claim->expected_verdict) return Expectation::met;
  if (judgement.is_unexpected()) return Expectation::unexpected;
  const bool decided =
      judgement.verdict != Verdict::not_measured && judgement.verdict != Verdict::inconclusive;
  return decided ? Expectation::depends_on_machine : Expectation::undecided;
}

/// As machine formats name it; these words never change.
inline std::string_view name_of(Expectation expectation) {
  switch (expectation) {
    case Expectation::met:
      return "met";
    case Expectation::unexpected:
      return "unexpected";
    case Expectation::depends_on_machine:
      return "depends on the machine";
    case Expectation::undecided:
      return "undecided";
  }
  return "";
}

}  // namespace phytobench
