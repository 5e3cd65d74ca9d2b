// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// A line of CSV (RFC 4180), fields quoted where needed.
std::string csv_line(const std::vector<std::string>& fields);

/// One row per claim, with all that the report says of it. Left out on request: what rests on
/// times.
std::string claims_csv(const JudgedRun& judged, bool without_varying);

/// Every record and every raw sample of one run, one a row (long format). Left out on request:
/// samples.
std::string records_csv(const RunContents& run, bool without_varying);

/// The same of several runs, with first columns that name the run: the letter by which claims.csv
/// calls it, and its label.
std::string records_csv(std::span<const ComparedRun> runs, bool without_varying);

/// One row per claim and run: what each run alone says. Left out on request: what rests on times.
std::string claims_by_run_csv(const RunComparison& comparison, bool without_varying);

/// One row per run and record that is not the same, bit for bit, in all runs that have it.
std::string differing_records_csv(const RunComparison& comparison);

}  // namespace phytobench
