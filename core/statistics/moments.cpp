// SPDX-License-Identifier: MIT
#include "core/statistics/moments.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

CentredValues centred(std::span<const double> values) {
  PHYTOBENCH_EXPECT(!values.empty());
  const double first = values.front();
  double excess = 0.0;
  for (const double value : values) {
    PHYTOBENCH_EXPECT(std::isfinite(value));
    excess += value - first;
  }
  CentredValues result{first + excess / static_cast<double>(values.size()), {}};
  result.deviations.reserve(values.size());
  for (const double value : values) result.deviations.push_back(value - result.mean);
  return result;
}

double product_sum(std::span<const double> first, std::span<const double> second) {
  PHYTOBENCH_EXPECT(first.size() == second.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) sum += first[i] * second[i];
  return sum;
}

double mean(std::span<const double> values) {
  return centred(values).mean;
}

double variance(std::span<const double> values) {
  PHYTOBENCH_EXPECT(values.size() > 1);
  const std::vector<double> deviations = centred(values).deviations;
  double sum = 0.0;  // 0, had the mean not been rounded
  for (const double deviation : deviations) sum += deviation;
  const auto count = static_cast<double>(values.size());
  return (product_sum(deviations, deviations) - sum * sum / count) / (count - 1.0);
}

double standard_deviation(std::span<const double> values) {
  return std::sqrt(variance(values));
}

double lag_1_autocorrelation(std::span<const double> values) {
  const std::vector<double> deviations = centred(values).deviations;
  const std::span<const double> all(deviations);
  const double squares = product_sum(all, all);
  PHYTOBENCH_EXPECT(squares > 0.0);
  return product_sum(all.first(all.size() - 1), all.last(all.size() - 1)) / squares;
}

}  // namespace phytobench
