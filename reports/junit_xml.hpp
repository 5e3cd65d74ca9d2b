// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// The verdicts in the form in which test runners report (JUnit XML): a suite per paper, a case per
/// claim. A case fails only where the verdict is not the expected one - a refuted claim that was
/// expected to be refuted passes - and is skipped where the run decides nothing. Claims that rest
/// on times are skipped on request. The property `expectation` is that of verdicts.json; a verdict
/// that is not the expected one because it depends on the machine is no failure: its case says so
/// in <system-out>. `comparison`: of a merged run, else null; each suite then has a property per
/// run, "run A" with its label, since reasons and measured values call the runs by their letters.
std::string junit_xml(const JudgedRun& judged, bool without_varying,
                      const RunComparison* comparison = nullptr);

}  // namespace phytobench
