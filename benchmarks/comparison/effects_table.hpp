// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison_report.hpp"

namespace phytobench {

/// Columns of plain text that stand alike in a terminal, a log and a comment: verdict, ratio with
/// its 95 % interval, noise floor, a strip with the interval on an axis of log ratios, name. In
/// the strip ':' is 1, '.' the tolerance, '-' the interval, 'o' the estimate, '<' and '>' an end
/// beyond the strip.
struct EffectsTable {
  std::string heading;            ///< one line, with its end
  std::vector<std::string> rows;  ///< by_weight(), each with its line end
};

EffectsTable effects_table(const ComparisonReport& report);

}  // namespace phytobench
