// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// A number without decimals, in groups of three digits.
std::string with_thousands(double value);

/// A cell's text and, where it has one, its interval.
nlohmann::ordered_json table_cell(const std::string& text, const std::string& interval = "");

/// A published table and what belongs to it as grids of ready texts, all in the layout of the work.
nlohmann::ordered_json table_document(const JudgedTable& judged, bool without_varying);

}  // namespace phytobench
