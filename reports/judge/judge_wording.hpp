// SPDX-License-Identifier: MIT
// How the judge words what it compared. Nothing is decided here.
#pragma once

#include <string>
#include <vector>

#include "reports/judge/judge.hpp"

namespace phytobench {

/// "squared.s/seconds : binary.s/seconds", without the experiments that the claim makes clear.
std::string expression_of(const ClaimCheck& check, const std::vector<std::string>& term);

/// Words the numbers of all terms and the bounds that they were held against, with as many digits
/// as it takes to see on which side of its bounds each lies.
void word_numbers(const ClaimCheck& check, JudgedCheck& judged);

}  // namespace phytobench
