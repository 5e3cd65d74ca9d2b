// SPDX-License-Identifier: MIT
#include "core/statistics/f_distribution.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double beta_rounding = 1e-12;  // of the incomplete beta function

TEST(FDistribution, HasClosedFormsForTwoDegrees) {
  for (const double x : {0.0, 0.1, 1.0, 3.7, 50.0}) {
    // F(2, 2): x / (1 + x).  F(2, m): 1 - (1 + 2 x / m)^(-m / 2).
    EXPECT_NEAR(f_probability(x, {2.0, 2.0}), x / (1.0 + x), beta_rounding);
    const double tail = std::pow(1.0 + 2.0 * x / 7.0, -3.5);
    EXPECT_NEAR(f_tail(x, {2.0, 7.0}), tail, beta_rounding * tail);
  }
}

TEST(FDistribution, IsTheTabulatedOne) {
  constexpr double printed = 5e-5;  // four decimals
  EXPECT_NEAR(f_quantile(0.95, {1.0, 1.0}), 161.4476, printed);
  EXPECT_NEAR(f_quantile(0.95, {5.0, 10.0}), 3.3258, printed);
  EXPECT_NEAR(f_quantile(0.975, {100.0, 100.0}), 1.4833, printed);
}

TEST(FDistributionLaw, QuantileAndReciprocalInvert) {
  for (const FDegrees degrees : {FDegrees{1.0, 3.0}, {20.0, 20.0}, {100.0, 7.5}})
    for (const double p : {1e-6, 0.025, 0.5, 0.9, 0.999}) {
      const double x = f_quantile(p, degrees);
      EXPECT_NEAR(f_probability(x, degrees), p, beta_rounding);
      EXPECT_NEAR(f_tail(x, degrees), 1.0 - p, beta_rounding);
      EXPECT_NEAR(f_tail(1.0 / x, {degrees.denominator, degrees.numerator}), p, beta_rounding);
    }
  EXPECT_NEAR(f_probability(1.0, {42.0, 42.0}), 0.5, beta_rounding);
}

TEST(FDistribution, EndsAndRefusals) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(f_probability(infinity, {3.0, 4.0}), 1.0);
  EXPECT_EQ(f_tail(infinity, {3.0, 4.0}), 0.0);
  EXPECT_EQ(f_quantile(0.0, {3.0, 4.0}), 0.0);
  EXPECT_THROW(f_probability(-1.0, {3.0, 4.0}), ContractViolation);
  EXPECT_THROW(f_probability(NAN, {3.0, 4.0}), ContractViolation);
  EXPECT_THROW(f_tail(1.0, {0.0, 4.0}), ContractViolation);
  EXPECT_THROW(f_quantile(1.0, {3.0, 4.0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
