// SPDX-License-Identifier: MIT
#include "core/statistics/order_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

double quantile(std::span<const double> values, double probability) {
  PHYTOBENCH_EXPECT(!values.empty());
  PHYTOBENCH_EXPECT(probability >= 0.0 && probability <= 1.0);
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

double median(std::span<const double> values) {
  return quantile(values, 0.5);
}

}  // namespace phytobench
