// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"
#include "reports/report_folder.hpp"

namespace phytobench {

/// Name of a printed table's file below tables/, without its ending: "brzoska2019-table-1".
std::string latex_table_name(const PublishedTable& table);

/// tables/*.tex: one file per printed table, one of counts, one of claims per work, claims.tex with
/// a command per claim, and all.tex, a document that holds them all.
ReportFiles latex_files(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
