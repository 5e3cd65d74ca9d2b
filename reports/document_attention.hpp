// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// What needs attention, in groups: refuted and undecided verdicts, unexpected ones, and those that
/// are not the expected ones because they depend on the machine.
nlohmann::ordered_json attention_document(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
