// SPDX-License-Identifier: MIT
// What `phytobench compare` says, writes and exits with.
#pragma once

#include <string>

#include "benchmarks/comparison/comparison_report.hpp"
#include "cli/commands.hpp"

namespace phytobench::cli {

/// Both sides, in what they differ, and which plugin failed its trial or else the table of effects,
/// counts and advice.
std::string comparison_text(const ComparisonReport& report);

/// Writes files and standard output. Returns the exit code: 1 if something is slower, has a wrong
/// answer or failed its trial, 4 if no benchmark was measured, 5 with --strict if something is
/// inconclusive, else 0.
int show_comparison(const ComparisonReport& report, const CompareOptions& options);

}  // namespace phytobench::cli
