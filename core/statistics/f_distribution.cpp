// SPDX-License-Identifier: MIT
#include "core/statistics/f_distribution.hpp"

#include <cmath>

#include <boost/math/distributions/fisher_f.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

boost::math::fisher_f distribution_of(const FDegrees& degrees) {
  PHYTOBENCH_EXPECT(std::isfinite(degrees.numerator) && degrees.numerator > 0.0);
  PHYTOBENCH_EXPECT(std::isfinite(degrees.denominator) && degrees.denominator > 0.0);
  return {degrees.numerator, degrees.denominator};
}

}  // namespace

double f_probability(double x, const FDegrees& degrees) {
  PHYTOBENCH_EXPECT(x >= 0.0);
  const auto distribution = distribution_of(degrees);
  return std::isinf(x) ? 1.0 : cdf(distribution, x);
}

double f_tail(double x, const FDegrees& degrees) {
  PHYTOBENCH_EXPECT(x >= 0.0);
  const auto distribution = distribution_of(degrees);
  return std::isinf(x) ? 0.0 : cdf(complement(distribution, x));
}

double f_quantile(double probability, const FDegrees& degrees) {
  PHYTOBENCH_EXPECT(probability >= 0.0 && probability < 1.0);
  return quantile(distribution_of(degrees), probability);
}

}  // namespace phytobench
