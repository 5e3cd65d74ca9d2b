// SPDX-License-Identifier: MIT
#include "core/statistics/midranks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contract/check.hpp"

namespace phytobench {

std::vector<std::int64_t> doubled_midranks(std::span<const double> values) {
  for (const double value : values) PHYTOBENCH_EXPECT(!std::isnan(value));
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::int64_t> ranks(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    // Ranks first + 1 to end: twice their mean is the sum of both.
    for (std::size_t i = first; i < end; ++i)
      ranks[order[i]] = static_cast<std::int64_t>(first + 1 + end);
  }
  return ranks;
}

}  // namespace phytobench
