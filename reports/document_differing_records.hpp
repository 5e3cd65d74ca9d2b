// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// How many measurements several runs share, how many of those are equal, and those that are not,
/// experiment by experiment, as ready texts. Of each experiment the ten largest differences.
nlohmann::ordered_json differing_records_document(const RunComparison& comparison);

}  // namespace phytobench
