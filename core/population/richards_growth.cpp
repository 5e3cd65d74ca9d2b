// SPDX-License-Identifier: MIT
#include "core/population/richards_growth.hpp"

#include <cmath>

#include "core/contract/check.hpp"
#include "core/population/shape_functions.hpp"

namespace phytobench {

namespace {

/// log(1 - e^(-s) + e^(z - s)) for s >= 0: a sum of two terms that are not negative, so that
/// nothing cancels, and in which e^z must not overflow.
double log_of_mixture(double s, double z) {
  const double gone = -std::expm1(-s), grown = z - s;
  return grown > 0.0 ? grown + std::log1p(gone * std::exp(-grown))
                     : std::log(gone + std::exp(grown));
}

}  // namespace

bool is_valid(const RichardsGrowth& growth) {
  return growth.rate > 0.0 && std::isfinite(growth.rate) && growth.final_size > 0.0 &&
         std::isfinite(growth.final_size) && std::isfinite(growth.shape);
}

double richards_rate(const RichardsGrowth& growth, double size) {
  PHYTOBENCH_EXPECT(is_valid(growth) && size > 0.0 && std::isfinite(size));
  const double bend = growth.shape - 1.0, log_size = log_ratio(size, growth.final_size);
  return -growth.rate * size * log_size * exponential_quotient(bend * log_size);
}

// With y = (v / w)^(1 - delta) = e^z the law is linear: y - 1 decays as e^(-k t).
double richards_size(const RichardsGrowth& growth, double initial, double time) {
  PHYTOBENCH_EXPECT(is_valid(growth) && initial > 0.0 && std::isfinite(initial) && time >= 0.0);
  const double bend = growth.shape - 1.0, log_start = log_ratio(initial, growth.final_size);
  const double s = growth.rate * time, left = std::exp(-s), z = -bend * log_start;
  const double log_size = std::abs(z) < 0.5 ? left * log_start * exponential_quotient(z) *
                                                  logarithm_quotient(left * std::expm1(z))
                                            : -log_of_mixture(s, z) / bend;
  return growth.final_size * std::exp(log_size);
}

std::optional<double> richards_inflection_size(const RichardsGrowth& growth) {
  PHYTOBENCH_EXPECT(is_valid(growth));
  if (growth.shape <= 0.0) return std::nullopt;
  return growth.final_size * std::exp(-logarithm_quotient(growth.shape - 1.0));
}

std::optional<double> richards_largest_rate(const RichardsGrowth& growth) {
  PHYTOBENCH_EXPECT(is_valid(growth));
  if (growth.shape < 0.0) return std::nullopt;
  const double bend =
      growth.shape == 0.0 ? 0.0 : growth.shape * logarithm_quotient(growth.shape - 1.0);
  return growth.rate * growth.final_size * std::exp(-bend);
}

std::optional<double> richards_initial_relative_rate(const RichardsGrowth& growth) {
  PHYTOBENCH_EXPECT(is_valid(growth));
  if (growth.shape <= 1.0) return std::nullopt;
  return growth.rate / (growth.shape - 1.0);
}

RichardsGrowth radius_growth(double printed_highest_rate, double largest_radius) {
  PHYTOBENCH_EXPECT(printed_highest_rate > 0.0 && largest_radius > 0.0);
  return {printed_highest_rate / largest_radius, largest_radius, 2.0};
}

}  // namespace phytobench
