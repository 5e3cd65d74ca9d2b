// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// A published table and what belongs to it as grids of ready texts, all in the layout of the work.
nlohmann::ordered_json table_document(const JudgedTable& judged, bool without_varying);

}  // namespace phytobench
