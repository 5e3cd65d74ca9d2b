// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_costs.hpp"
#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// How to repeat a run as a whole and each experiment alone, with what that costs. `command_line`
/// is the run's own.
nlohmann::ordered_json repeat_document(const JudgedRun& judged, const ExperimentCosts& costs,
                                       const std::string& command_line);

}  // namespace phytobench
