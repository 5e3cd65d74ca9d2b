// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/comparison/comparison_report.hpp"

namespace phytobench {

/// One test case for each benchmark: slower, a wrong answer and nothing measured are failures;
/// inconclusive is skipped, with a message; everything else has passed.
std::string comparison_junit(const ComparisonReport& report);

}  // namespace phytobench
