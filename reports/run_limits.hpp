// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// What a run lacks, in plain sentences: an experiment whose records break off, and experiments
/// that claims of its tier rest on. Empty for a whole run.
std::string incompleteness(const JudgedRun& judged);

/// What a run cannot tell, as sentences; what it lacks comes first.
std::vector<std::string> run_limits(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
