// SPDX-License-Identifier: MIT
// Confidence intervals of a median from order statistics. Their coverage is known exactly for
// independent values of any continuous law; nothing is drawn and nothing is approximated.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// Ranks of two values in ascending order, the smallest has rank 1.
struct RankInterval {
  std::size_t low = 1;
  std::size_t high = 1;
};

/// How often the values of these ranks of `count` independent ones enclose the median of their
/// continuous law: sum of C(count, i) / 2^count for i from low to high - 1. For laws with atoms at
/// least as often. 1 <= low <= high <= count; ContractViolation otherwise.
double median_coverage(std::size_t count, const RankInterval& ranks);

/// The narrowest pair of ranks, equally far from both ends, that covers the median at least as
/// often as `confidence`. Nothing if not even the extremes do: fewer than six values for 0.95.
std::optional<RankInterval> median_ranks(std::size_t count, double confidence = 0.95);

/// median() with the values of median_ranks(). Nothing where there are none.
std::optional<Estimate> median_interval(std::span<const double> samples, double confidence = 0.95);

}  // namespace phytobench
