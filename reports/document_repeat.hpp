// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/document_costs.hpp"
#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// How to repeat a run as a whole and each experiment alone, with what that costs. What a run
/// holds counts, not how it was started: a resumed run was started more than once. `comparison`: of
/// a merged run, each of which is repeated in a folder of its own; else null.
nlohmann::ordered_json repeat_document(const JudgedRun& judged, const ExperimentCosts& costs,
                                       const RunComparison* comparison);

}  // namespace phytobench
