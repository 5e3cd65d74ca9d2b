// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// verdicts.json: every claim with its verdict, for programs. Of several runs (`comparison` is not
/// null) also what each of them says. Left out on request: claims that rest on times.
/// `expectation` says how a verdict stands to the expected one: "met", "unexpected", "undecided"
/// (not measured or inconclusive), or "depends on the machine" - otherwise than expected, on times
/// of which `machine_dependence` (else null) says on which processors they come out how.
std::string verdicts_json(const JudgedRun& judged, const RunComparison* comparison,
                          bool without_varying);

}  // namespace phytobench
