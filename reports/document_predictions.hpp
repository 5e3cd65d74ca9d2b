// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Verdicts predicted from the texts, against those of this run: how often
/// each met each, and every claim where the two differ. Claims without evidence in this run, hidden
/// ones and those that wait for a model are counted apart: nothing was found for them.
nlohmann::ordered_json predictions_document(const JudgedRun& judged, bool without_varying);

/// Claims whose verdict is not the expected one and is known to depend on the machine: neither as
/// expected nor unexpected.
nlohmann::ordered_json machine_dependent(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
