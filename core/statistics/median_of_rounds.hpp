// SPDX-License-Identifier: MIT
// What repeated timings say of their median: the one rule for everything that is timed in rounds,
// whoever shows it or judges by it.
#pragma once

#include <cstddef>
#include <span>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// Of fewer rounds not even the extremes enclose the median 95 times in 100.
inline constexpr std::size_t fewest_rounds = 6;

/// Median of rounds. From `fewest_rounds` on, `low` and `high` are median_interval(), which
/// encloses the median of independent rounds at least 95 times in 100. Of fewer they are the
/// smallest and the largest that were seen: a range, which decides nothing.
struct MedianOfRounds : Estimate {
  std::size_t rounds = 0;  ///< 0: not timed in rounds, the value is exact

  /// Whether there were rounds, but too few for an interval.
  bool is_only_range() const { return 0 < rounds && rounds < fewest_rounds; }
};

/// Samples need no order, one per round. At least one; ContractViolation otherwise.
MedianOfRounds median_of_rounds(std::span<const double> samples);

/// Of the ratios numerator[i] / denominator[i] of what was timed in the same round. Pairing removes
/// what both shared: the machine's mood. At least one pair, and spans of equal size;
/// ContractViolation otherwise.
MedianOfRounds ratio_of_rounds(std::span<const double> numerator,
                               std::span<const double> denominator);

}  // namespace phytobench
