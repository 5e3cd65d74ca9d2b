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

}  // namespace phytobench
