// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_places.hpp"
#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// A cell's text and, where it has one, its interval.
nlohmann::ordered_json table_cell(const std::string& text, const std::string& interval = "");

/// A published table and what belongs to it as grids of ready texts, all in the layout of the work:
/// a cell of the printed one leads to the claim about it, and a grid of its own says its verdict.
nlohmann::ordered_json table_document(const JudgedTable& judged, const ClaimIndex& claims,
                                      bool without_varying);

}  // namespace phytobench
