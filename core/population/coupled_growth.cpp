// SPDX-License-Identifier: MIT
#include "core/population/coupled_growth.hpp"

#include <cmath>

#include "core/contract/check.hpp"
#include "core/population/shape_functions.hpp"

namespace phytobench {

namespace {

void expect_valid(const CoupledGrowth& growth) {
  PHYTOBENCH_EXPECT(growth.rate > 0.0 && std::isfinite(growth.rate));
  PHYTOBENCH_EXPECT(growth.final_size > 0.0 && std::isfinite(growth.final_size));
  PHYTOBENCH_EXPECT(std::isfinite(growth.shape));
}

}  // namespace

OverlapShares::OverlapShares(std::size_t plants, std::vector<double> shares)
    : plants_(plants), shares_(std::move(shares)) {
  PHYTOBENCH_EXPECT(shares_.size() == plants * plants);
  for (const double share : shares_) PHYTOBENCH_EXPECT(share >= 0.0 && share <= 1.0);
  for (std::size_t i = 0; i < plants; ++i) PHYTOBENCH_EXPECT(of(i)[i] == 1.0);
}

OverlapShares OverlapShares::complete(std::size_t plants) {
  return {plants, std::vector<double>(plants * plants, 1.0)};
}

OverlapShares OverlapShares::none(std::size_t plants) {
  std::vector<double> shares(plants * plants, 0.0);
  for (std::size_t i = 0; i < plants; ++i) shares[i * plants + i] = 1.0;
  return {plants, std::move(shares)};
}

double size_factor(double size, double asymmetry) {
  PHYTOBENCH_EXPECT(size > 0.0 && asymmetry >= 0.0);
  return std::pow(size, asymmetry);
}

std::vector<double> coupled_growth_rates(const CoupledGrowth& growth, const OverlapShares& shares,
                                         std::span<const double> sizes) {
  expect_valid(growth);
  PHYTOBENCH_EXPECT(sizes.size() == shares.plants());
  const double bend = growth.shape - 1.0;
  std::vector<double> rates;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    double pressing = 0.0;
    for (std::size_t j = 0; j < sizes.size(); ++j) pressing += shares.of(i)[j] * sizes[j];
    const double log_pressure = log_ratio(pressing, growth.final_size);
    rates.push_back(-growth.rate * size_factor(sizes[i], growth.asymmetry) * log_pressure *
                    exponential_quotient(bend * log_pressure));
  }
  return rates;
}

double conserved_scale(double size, double asymmetry) {
  PHYTOBENCH_EXPECT(size > 0.0 && asymmetry >= 0.0);
  const double log_size = std::log(size);
  return log_size * exponential_quotient((1.0 - asymmetry) * log_size);
}

std::pair<double, double> end_sizes_of_two(double final_size, double asymmetry,
                                           std::pair<double, double> sizes) {
  const auto [first, second] = sizes;
  PHYTOBENCH_EXPECT(first > 0.0 && second >= first && first + second <= final_size);
  const auto apart = [&](double low, double high) {
    return conserved_scale(high, asymmetry) - conserved_scale(low, asymmetry);
  };
  // The larger the smaller plant, the less they differ: halve until no number lies between.
  const double difference = apart(first, second);
  double low = first, high = 0.5 * final_size;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return {low, final_size - low};
    (apart(middle, final_size - middle) >= difference ? low : high) = middle;
  }
}

}  // namespace phytobench
