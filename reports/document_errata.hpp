// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Misprints of a work, in its own order, with the claims that need them. Where the work is sound
/// as printed and only its program does otherwise, the other form is called that, no correction.
nlohmann::ordered_json errata_document(const JudgedPaper& judged);

/// What a work leaves open, our readings of it, and the claims that rest on them.
nlohmann::ordered_json assumptions_document(const JudgedPaper& judged);

}  // namespace phytobench
