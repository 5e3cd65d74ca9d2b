// SPDX-License-Identifier: MIT
// The clauses by which a verdict on times is explained: numbers first, in percent.
#pragma once

#include <cstddef>
#include <string>

#include "benchmarks/comparison/comparison.hpp"
#include "core/statistics/estimate.hpp"

namespace phytobench {

/// A ratio as a change: "+8.4 % [6.1, 10.2]".
std::string change_text(const Estimate& ratio);

/// Why it is slower or faster.
std::string beyond_doubt(const ConcludedBenchmark& benchmark, const VerdictSettings& settings);

/// Why it is the same.
std::string within_tolerance(const ConcludedBenchmark& benchmark, const VerdictSettings& settings);

/// Why its ratio and control say neither. `tested`: how many benchmarks p was adjusted for.
std::string doubt(const ConcludedBenchmark& benchmark, const VerdictSettings& settings,
                  std::size_t tested);

/// Why nothing is said though there is a ratio: the control shows a change.
std::string broken_instrument(const Estimate& control);

}  // namespace phytobench
