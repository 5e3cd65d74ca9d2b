// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Misprints of a work, in its own order, with the claims that need them.
nlohmann::ordered_json errata_document(const JudgedPaper& judged);

/// What a work leaves open, our readings of it, and the claims that rest on them.
nlohmann::ordered_json assumptions_document(const JudgedPaper& judged);

}  // namespace phytobench
