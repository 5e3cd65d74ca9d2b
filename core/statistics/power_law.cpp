// SPDX-License-Identifier: MIT
#include "core/statistics/power_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

std::vector<double> logs(std::span<const double> values) {
  std::vector<double> results;
  for (const double value : values) {
    PHYTOBENCH_EXPECT(std::isfinite(value) && value > 0.0);
    results.push_back(std::log(value));
  }
  return results;
}

/// Takes the mean off the values and returns it.
double centre(std::vector<double>& values) {
  const double first = values.front();
  double excess = 0.0;
  for (const double value : values) excess += value - first;
  const double mean = first + excess / static_cast<double>(values.size());
  for (double& value : values) value -= mean;
  return mean;
}

double product_sum(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y,
                                      double confidence) {
  PHYTOBENCH_EXPECT(x.size() == y.size());
  PHYTOBENCH_EXPECT(confidence > 0.0 && confidence < 1.0);
  std::vector<double> log_x = logs(x), log_y = logs(y);
  if (log_x.size() < 3) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(log_x.begin(), log_x.end());
  if (*lowest == *highest) return std::nullopt;

  // Centred logs keep large means out of the sums of products.
  const double mean_x = centre(log_x), mean_y = centre(log_y);
  const double spread = product_sum(log_x, log_x);
  const double slope = product_sum(log_x, log_y) / spread;

  // Residuals one by one: differences of large sums of squares would cancel.
  for (std::size_t i = 0; i < log_y.size(); ++i) log_y[i] -= slope * log_x[i];
  const double degrees_of_freedom = static_cast<double>(log_x.size() - 2);
  const double error = std::sqrt(product_sum(log_y, log_y) / degrees_of_freedom / spread);

  const boost::math::students_t distribution(degrees_of_freedom);
  const double tail = 0.5 * (1.0 - confidence);
  const double half_width = quantile(complement(distribution, tail)) * error;
  return PowerLaw{{slope, slope - half_width, slope + half_width},
                  std::exp(mean_y - slope * mean_x)};
}

}  // namespace phytobench
