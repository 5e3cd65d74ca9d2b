// SPDX-License-Identifier: MIT
#include "core/statistics/kolmogorov_smirnov.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// 1 - Kolmogorov's limit law, by whichever of its two series converges at once.
double kolmogorov_tail(double x) {
  constexpr double pi = std::numbers::pi;
  if (x <= 0.0) return 1.0;
  double sum = 0.0;
  if (x < 1.0) {
    for (int k = 1; k <= 5; k += 2) sum += std::exp(-k * k * pi * pi / (8.0 * x * x));
    return 1.0 - std::sqrt(2.0 * pi) / x * sum;
  }
  for (int k = 1; k <= 5; ++k) sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
  return sum;
}

}  // namespace

double kolmogorov_distance(std::span<const double> values) {
  PHYTOBENCH_EXPECT(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  for (double& value : sorted) {
    PHYTOBENCH_EXPECT(!std::isnan(value));
    value = std::clamp(value, 0.0, 1.0);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto count = static_cast<double>(sorted.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double below = static_cast<double>(i) / count, upto = static_cast<double>(i + 1) / count;
    distance = std::max({distance, sorted[i] - below, upto - sorted[i]});
  }
  return distance;
}

double kolmogorov_p_value(double distance, std::size_t count) {
  PHYTOBENCH_EXPECT(count > 0 && distance >= 0.0 && distance <= 1.0);
  const double root = std::sqrt(static_cast<double>(count));
  return kolmogorov_tail((root + 0.12 + 0.11 / root) * distance);
}

double kolmogorov_uniformity_p_value(std::span<const double> values) {
  return kolmogorov_p_value(kolmogorov_distance(values), values.size());
}

}  // namespace phytobench
