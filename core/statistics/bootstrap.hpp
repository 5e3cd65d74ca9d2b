// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/statistics/estimate.hpp"

namespace phytobench {

struct BootstrapSettings {
  double confidence = 0.95;
  int resamples = 10000;
  std::uint64_t seed = 20190906;  ///< fixed, so that a report is the same each time it is made
};

/// Median with a percentile bootstrap interval. At least one sample; a single one gives an interval
/// of width zero, which says nothing. Of few samples it holds the median less often than it says
/// (of three 75 times in 100): for times in rounds see median_of_rounds().
Estimate median_estimate(std::span<const double> samples, const BootstrapSettings& settings = {});

/// Median of the ratios numerator[i] / denominator[i] of paired samples (same round of an
/// interleaved run), with a percentile bootstrap over the pairs. Pairing removes what both shared:
/// the machine's mood.
Estimate paired_ratio_estimate(std::span<const double> numerator,
                               std::span<const double> denominator,
                               const BootstrapSettings& settings = {});

}  // namespace phytobench
