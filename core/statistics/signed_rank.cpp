// SPDX-License-Identifier: MIT
#include "core/statistics/signed_rank.hpp"

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
struct SignedRanks {
  std::vector<std::int64_t> ranks;  ///< of the differences other than 0
  std::int64_t positive_sum = 0;
};

SignedRanks signed_ranks(std::span<const double> differences) {
  std::vector<double> sizes;
  for (const double difference : differences) {
    PHYTOBENCH_EXPECT(std::isfinite(difference));
    sizes.push_back(std::abs(difference));
  }
  const std::vector<std::int64_t> all = doubled_midranks(sizes);
  SignedRanks result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (differences[i] != 0.0) result.ranks.push_back(all[i]);
    if (differences[i] > 0.0) result.positive_sum += all[i];
  }
  return result;
}

/// Probability of each sum of ranks, a fair coin deciding on every rank.
std::vector<double> sum_probabilities(const std::vector<std::int64_t>& ranks) {
  const auto largest = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
  std::vector<double> probabilities(static_cast<std::size_t>(largest) + 1, 0.0);
  probabilities[0] = 1.0;
  for (const std::int64_t rank : ranks) {
    const auto step = static_cast<std::size_t>(rank);
    // Downwards, so that what is added has not yet had this coin.
    for (std::size_t sum = probabilities.size(); sum-- > 0;)
      probabilities[sum] =
          0.5 * (probabilities[sum] + (sum >= step ? probabilities[sum - step] : 0.0));
  }
  return probabilities;
}

void set_exact(SignedRankTest& test, const SignedRanks& signs) {
  const std::vector<double> probabilities = sum_probabilities(signs.ranks);
  const auto at = probabilities.begin() + signs.positive_sum;
  test.p_greater = std::min(1.0, std::accumulate(at, probabilities.end(), 0.0));
  test.p_less = std::min(1.0, std::accumulate(probabilities.begin(), at + 1, 0.0));
}

void set_normal(SignedRankTest& test, const SignedRanks& signs) {
  double mean = 0.0, variance = 0.0;
  for (const std::int64_t rank : signs.ranks) {
    const double half = 0.5 * static_cast<double>(rank);
    mean += half;
    variance += half * half;
  }
  const double excess = static_cast<double>(signs.positive_sum) - mean;
  constexpr double continuity = 1.0;  // half a rank, doubled
  const double scale = 1.0 / std::sqrt(2.0 * variance);
  test.p_greater = 0.5 * boost::math::erfc(scale * (excess - continuity));
  test.p_less = 0.5 * boost::math::erfc(-scale * (excess + continuity));
}

}  // namespace

SignedRankTest signed_rank_test(std::span<const double> differences,
                                const SignedRankSettings& settings) {
  const SignedRanks signs = signed_ranks(differences);
  SignedRankTest test{.signs = signs.ranks.size(),
                      .positive_sum = 0.5 * static_cast<double>(signs.positive_sum)};
  if (test.signs == 0) return test;
  if (test.signs <= settings.largest_exact)
    set_exact(test, signs);
  else
    set_normal(test, signs);
  test.p_two_sided = std::min(1.0, 2.0 * std::min(test.p_greater, test.p_less));
  return test;
}

}  // namespace phytobench
