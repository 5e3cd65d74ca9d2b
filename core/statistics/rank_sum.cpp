// SPDX-License-Identifier: MIT
#include "core/statistics/rank_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <boost/math/special_functions/erf.hpp>

#include "core/contract/check.hpp"
#include "core/statistics/midranks.hpp"

namespace phytobench {

namespace {

/// All in doubled ranks, which are whole.
struct RankedSamples {
  std::vector<std::int64_t> ranks;  ///< of both samples, the first one's in front
  std::size_t first_size = 0;
  std::int64_t first_sum = 0;
};

RankedSamples ranked(std::span<const double> first, std::span<const double> second) {
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  RankedSamples samples{doubled_midranks(all), first.size(), 0};
  const auto end = samples.ranks.begin() + static_cast<std::ptrdiff_t>(first.size());
  samples.first_sum = std::accumulate(samples.ranks.begin(), end, std::int64_t{0});
  return samples;
}

/// In how many ways `size` of the ranks have each sum.
std::vector<double> sum_counts(const std::vector<std::int64_t>& ranks, std::size_t size) {
  std::vector<std::int64_t> descending = ranks;
  std::sort(descending.rbegin(), descending.rend());
  const auto end = descending.begin() + static_cast<std::ptrdiff_t>(size);
  const auto largest =
      static_cast<std::size_t>(std::accumulate(descending.begin(), end, std::int64_t{0}));
  // ways[k][s]: choices of k ranks with sum s among the ranks so far.
  std::vector<std::vector<double>> ways(size + 1, std::vector<double>(largest + 1, 0.0));
  ways[0][0] = 1.0;
  for (const std::int64_t rank : ranks) {
    const auto step = static_cast<std::size_t>(rank);
    // Downwards, so that no rank is chosen twice.
    for (std::size_t k = size; k > 0; --k)
      for (std::size_t sum = step; sum <= largest; ++sum) ways[k][sum] += ways[k - 1][sum - step];
  }
  return ways[size];
}

void set_exact(RankSumTest& test, const RankedSamples& samples) {
  const std::vector<double> counts = sum_counts(samples.ranks, samples.first_size);
  const auto at = counts.begin() + samples.first_sum;
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  test.p_greater = std::min(1.0, std::accumulate(at, counts.end(), 0.0) / all);
  test.p_less = std::min(1.0, std::accumulate(counts.begin(), at + 1, 0.0) / all);
}

void set_normal(RankSumTest& test, const RankedSamples& samples) {
  const auto m = static_cast<double>(samples.first_size);
  const auto all = static_cast<double>(samples.ranks.size());
  const double mean_rank = all + 1.0;
  double squares = 0.0;
  for (const std::int64_t rank : samples.ranks)
    squares += (static_cast<double>(rank) - mean_rank) * (static_cast<double>(rank) - mean_rank);
  if (squares == 0.0) return;  // all are equal
  // Of a sum of m ranks drawn without return.
  const double variance = m * (all - m) / (all * (all - 1.0)) * squares;
  const double excess = static_cast<double>(samples.first_sum) - m * mean_rank;
  constexpr double continuity = 1.0;  // half a pair, doubled
  const double scale = 1.0 / std::sqrt(2.0 * variance);
  test.p_greater = 0.5 * boost::math::erfc(scale * (excess - continuity));
  test.p_less = 0.5 * boost::math::erfc(-scale * (excess + continuity));
}

}  // namespace

RankSumTest rank_sum_test(std::span<const double> first, std::span<const double> second,
                          const RankSumSettings& settings) {
  PHYTOBENCH_EXPECT(!first.empty() && !second.empty());
  const RankedSamples samples = ranked(first, second);
  const auto m = static_cast<double>(first.size());
  RankSumTest test{.u = 0.5 * (static_cast<double>(samples.first_sum) - m * (m + 1.0))};
  if (samples.ranks.size() <= settings.largest_exact)
    set_exact(test, samples);
  else
    set_normal(test, samples);
  test.p_two_sided = std::min(1.0, 2.0 * std::min(test.p_greater, test.p_less));
  return test;
}

}  // namespace phytobench
