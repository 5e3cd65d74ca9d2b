// SPDX-License-Identifier: MIT
#include "core/random/distributions.hpp"

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Knuth's multiplication: how many factors until the product falls to exp(-mean).
std::uint64_t poisson_by_products(double mean, UnitStream& stream) {
  const double end = std::exp(-mean);
  std::uint64_t count = 0;
  for (double product = 1.0 - stream.next_unit(); product > end; ++count)
    product *= 1.0 - stream.next_unit();
  return count;
}

/// Logarithm of the Poisson probability of k. Not std::lgamma, which writes a global variable.
double log_poisson(double k, double mean) {
  return k * std::log(mean) - mean - boost::math::lgamma(k + 1.0);
}

/// Hoermann's PTRS, for means of 10 and more. Letters and constants as in his paper: the table
/// mountain's hat has the inverse (2 a / (0.5 - |u|) + b) u + c, v_r bounds the immediate
/// acceptance, inverse_alpha is the hat's height.
std::uint64_t poisson_by_rejection(double mean, UnitStream& stream) {
  const double b = 0.931 + 2.53 * std::sqrt(mean);
  const double a = -0.059 + 0.02483 * b;
  const double v_r = 0.9277 - 3.6224 / (b - 2.0);
  const double inverse_alpha = 1.1239 + 1.1328 / (b - 3.4);
  for (;;) {
    const double u = stream.next_unit() - 0.5;
    const double v = 1.0 - stream.next_unit();
    const double u_s = 0.5 - std::abs(u);
    const double k = std::floor((2.0 * a / u_s + b) * u + mean + 0.43);
    // Accept at once below the squeeze, which nine draws in ten hit.
    if (u_s >= 0.07 && v <= v_r) return static_cast<std::uint64_t>(k);
    if (k < 0.0 || (u_s < 0.013 && v > u_s)) continue;
    const double hat = v * inverse_alpha / (a / (u_s * u_s) + b);
    if (std::log(hat) <= log_poisson(k, mean)) return static_cast<std::uint64_t>(k);
  }
}

}  // namespace

double random_exponential(UnitStream& stream) {
  // log1p keeps the small gaps exact; the stream never gives 1.
  return -std::log1p(-stream.next_unit());
}

std::array<double, 2> random_normal_pair(UnitStream& stream) {
  const double radius = std::sqrt(2.0 * random_exponential(stream));
  const double angle = 2.0 * std::numbers::pi * stream.next_unit();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double random_normal(UnitStream& stream) {
  return random_normal_pair(stream)[0];
}

std::uint64_t random_poisson(double mean, UnitStream& stream) {
  PHYTOBENCH_EXPECT(mean >= 0.0 && mean <= largest_poisson_mean);
  constexpr double rejection_from = 10.0;  // below, the constants of PTRS give no valid hat
  return mean < rejection_from ? poisson_by_products(mean, stream)
                               : poisson_by_rejection(mean, stream);
}

}  // namespace phytobench
