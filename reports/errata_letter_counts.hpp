// SPDX-License-Identifier: MIT
// What the letter to an author says of claims: verdicts in plain words, and how many have which.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// "holds as it stands", "holds under our reading", "does not hold", ...
std::string plain_verdict(const Judgement& judgement, bool without_varying);

/// "3 hold as they stand", "1 does not hold": one text for each verdict that occurs.
std::vector<std::string> verdict_counts(std::span<const Judgement* const> judgements,
                                        bool without_varying);

/// The section on what was confirmed: counts of all verdicts, and each statement that did not hold
/// with what was found instead.
std::string confirmed_part(const JudgedPaper& judged, bool without_varying);

}  // namespace phytobench
