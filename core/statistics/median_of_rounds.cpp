// SPDX-License-Identifier: MIT
#include "core/statistics/median_of_rounds.hpp"

#include <algorithm>
#include <vector>

#include "core/contract/check.hpp"
#include "core/statistics/median_interval.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

MedianOfRounds median_of_rounds(std::span<const double> samples) {
  PHYTOBENCH_EXPECT(!samples.empty());
  if (const auto interval = median_interval(samples)) return {*interval, samples.size()};
  const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
  return {{median(samples), *least, *most}, samples.size()};
}

MedianOfRounds ratio_of_rounds(std::span<const double> numerator,
                               std::span<const double> denominator) {
  PHYTOBENCH_EXPECT(numerator.size() == denominator.size());
  std::vector<double> ratios;
  for (std::size_t i = 0; i < numerator.size(); ++i)
    ratios.push_back(numerator[i] / denominator[i]);
  return median_of_rounds(ratios);
}

}  // namespace phytobench
