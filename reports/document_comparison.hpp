// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// What several runs say beside each other, as ready texts: where they come from, verdicts of each,
/// claims they decide differently, records that are not the same, claims on times. `environments`
/// holds environment.json of each run. Left out on request: times and machines.
nlohmann::ordered_json comparison_document(const JudgedRun& merged, const RunComparison& comparison,
                                           std::span<const std::string> environments,
                                           bool without_varying);

}  // namespace phytobench
