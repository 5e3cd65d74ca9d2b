// SPDX-License-Identifier: MIT
#include "core/statistics/false_discovery_rate.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/contract/check.hpp"

namespace phytobench {

std::vector<double> false_discovery_adjusted(std::span<const double> p_values) {
  for (const double p : p_values) PHYTOBENCH_EXPECT(p >= 0.0 && p <= 1.0);
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Equal ones get the same whatever their order: the least is carried on from the last of them.
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  const auto n = static_cast<double>(p_values.size());
  std::vector<double> adjusted(p_values.size());
  double least = 1.0;
  for (std::size_t rank = order.size(); rank > 0; --rank) {
    const std::size_t place = order[rank - 1];
    // n / rank >= 1 as rounded, too, so the product is never below p.
    least = std::min(least, p_values[place] * (n / static_cast<double>(rank)));
    adjusted[place] = least;
  }
  return adjusted;
}

}  // namespace phytobench
