// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// What needs attention, in groups: refuted, undecided and unexpected verdicts.
nlohmann::ordered_json attention_document(const JudgedRun& judged, bool without_varying);

/// What this run cannot tell, as sentences.
nlohmann::ordered_json limits_document(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
