// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// What was measured although no claim rests on it: by experiment, and within it by name. Groups
/// whose names differ in numbers alone are one, with `*` for each number: a run has thousands of
/// measurements, and records.csv names them all. What experiments cost is told elsewhere.
nlohmann::ordered_json unclaimed_document(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
