// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "benchmarks/comparison/comparison_report.hpp"

namespace phytobench {

/// A comment on GitHub ends at 64 KiB; GitLab's notes and GitHub's step summaries may be longer.
inline constexpr std::size_t most_markdown_bytes = 60 * 1024;

/// For a comment or a step summary: what came out in one line, what was compared, what failed its
/// trial, what changed, all effects as a table, folded details, facts of the run. Each part is cut
/// before the whole exceeds most_markdown_bytes, and says how much is left to the JSON document.
std::string comparison_markdown(const ComparisonReport& report);

}  // namespace phytobench
