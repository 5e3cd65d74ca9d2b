// SPDX-License-Identifier: MIT
#include "core/statistics/median_interval.hpp"

#include <algorithm>
#include <vector>

#include <boost/math/special_functions/beta.hpp>

#include "core/contract/check.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

/// Probability that at most `successes` of `trials` tosses of a fair coin show heads.
double tosses_up_to(std::size_t successes, std::size_t trials) {
  if (successes >= trials) return 1.0;
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  return boost::math::ibeta(n - k, k + 1.0, 0.5);
}

}  // namespace

double median_coverage(std::size_t count, const RankInterval& ranks) {
  PHYTOBENCH_EXPECT(1 <= ranks.low && ranks.low <= ranks.high && ranks.high <= count);
  return tosses_up_to(ranks.high - 1, count) - tosses_up_to(ranks.low - 1, count);
}

std::optional<RankInterval> median_ranks(std::size_t count, double confidence) {
  PHYTOBENCH_EXPECT(confidence > 0.0 && confidence < 1.0);
  std::optional<RankInterval> narrowest;
  for (std::size_t low = 1; 2 * low <= count; ++low) {
    const RankInterval ranks{low, count + 1 - low};
    if (median_coverage(count, ranks) < confidence) break;
    narrowest = ranks;
  }
  return narrowest;
}

std::optional<Estimate> median_interval(std::span<const double> samples, double confidence) {
  const auto ranks = median_ranks(samples.size(), confidence);
  if (!ranks) return std::nullopt;
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  return Estimate{median(samples), sorted[ranks->low - 1], sorted[ranks->high - 1]};
}

}  // namespace phytobench
