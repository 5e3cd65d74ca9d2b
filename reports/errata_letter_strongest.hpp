// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// The errata by which a letter begins, at most five, by a rule and not by taste: certain ones
/// before probable ones; those with a worked example before others; formulas and numbers before
/// cases left out, and these before wording and bookkeeping; then those that concern more claims;
/// then the order of the work. Differences from the program of a work are none: they are sound as
/// printed. Points into `judged`.
std::vector<const Erratum*> strongest_errata(const JudgedPaper& judged);

}  // namespace phytobench
