// SPDX-License-Identifier: MIT
#include "core/statistics/gini.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Ascending: sums from small to large keep their digits and know no order of the plants.
std::vector<double> sorted(std::span<const double> values) {
  PHYTOBENCH_EXPECT(!values.empty());
  std::vector<double> result(values.begin(), values.end());
  for (const double value : result) PHYTOBENCH_EXPECT(std::isfinite(value) && value >= 0.0);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

double gini_coefficient(std::span<const double> values) {
  const std::vector<double> x = sorted(values);
  // With gaps g_i between neighbours in order, the sum of |x_i - x_j| is 2 sum i (n - i) g_i: terms
  // that are not negative, and 0 for equal values.
  const auto n = static_cast<double>(x.size());
  double differences = 0.0, sum = x[0];
  for (std::size_t i = 1; i < x.size(); ++i) {
    const auto below = static_cast<double>(i);
    differences += below * (n - below) * (x[i] - x[i - 1]);
    sum += x[i];
  }
  return sum == 0.0 ? 0.0 : differences / n / sum;
}

std::vector<LorenzPoint> lorenz_curve(std::span<const double> values) {
  const std::vector<double> x = sorted(values);
  std::vector<double> sums{0.0};
  for (const double value : x) sums.push_back(sums.back() + value);
  PHYTOBENCH_EXPECT(sums.back() > 0.0);
  std::vector<LorenzPoint> curve;
  for (std::size_t i = 0; i < sums.size(); ++i)
    curve.push_back(
        {static_cast<double>(i) / static_cast<double>(x.size()), sums[i] / sums.back()});
  return curve;
}

}  // namespace phytobench
