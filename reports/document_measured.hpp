// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judge.hpp"

namespace phytobench {

/// What was measured of a claim, short enough to stand above its evidence: up to four values as
/// they are; of more, how many, from which to which, and what keeps them from holding. Where the
/// verdict waits for missing values, only how many there are. Machine formats have all of them.
std::string shown_measured(const Judgement& judgement);

/// A term as readers see it: a sum does not begin with a plus.
std::string shown_expression(const JudgedTerm& term);

}  // namespace phytobench
