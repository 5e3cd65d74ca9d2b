// SPDX-License-Identifier: MIT
#include "core/statistics/power_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/distributions/students_t.hpp>

#include "core/contract/check.hpp"
#include "core/statistics/moments.hpp"

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

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y,
                                      double confidence) {
  PHYTOBENCH_EXPECT(x.size() == y.size());
  PHYTOBENCH_EXPECT(confidence > 0.0 && confidence < 1.0);
  const std::vector<double> log_x = logs(x), log_y = logs(y);
  if (log_x.size() < 3) return std::nullopt;
  const auto [lowest, highest] = std::minmax_element(log_x.begin(), log_x.end());
  if (*lowest == *highest) return std::nullopt;

  // Centred logs keep large means out of the sums of products.
  const CentredValues cx = centred(log_x), cy = centred(log_y);
  const double spread = product_sum(cx.deviations, cx.deviations);
  const double slope = product_sum(cx.deviations, cy.deviations) / spread;

  // Residuals one by one: differences of large sums of squares would cancel.
  std::vector<double> residuals = cy.deviations;
  for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] -= slope * cx.deviations[i];
  const double degrees_of_freedom = static_cast<double>(residuals.size() - 2);
  const double error = std::sqrt(product_sum(residuals, residuals) / degrees_of_freedom / spread);

  const boost::math::students_t distribution(degrees_of_freedom);
  const double tail = 0.5 * (1.0 - confidence);
  const double half_width = quantile(complement(distribution, tail)) * error;
  return PowerLaw{{slope, slope - half_width, slope + half_width},
                  std::exp(cy.mean - slope * cx.mean)};
}

}  // namespace phytobench
