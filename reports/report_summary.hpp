// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

struct ReportSummary {
  std::string text;            ///< a few lines for the terminal
  std::size_t unexpected = 0;  ///< verdicts that differ from the expected one
  std::size_t inconclusive = 0;
};

/// The counts by verdict and the unexpected verdicts of a run, and the experiment that it lacks
/// because its records break off.
ReportSummary report_summary(const JudgedRun& judged);

}  // namespace phytobench
