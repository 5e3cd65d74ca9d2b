// SPDX-License-Identifier: MIT
#include "core/statistics/power_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/test_values.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

constexpr double fit_rounding = 1e-12;  // of a few logarithms below 50 and their sums

Values powers(const Values& x, double factor, double exponent) {
  Values y;
  for (const double value : x) y.push_back(factor * std::pow(value, exponent));
  return y;
}

// Base-2 logarithms 0 1 2 3 4 and 1 2 4 5 8, by hand: slope 17/10, residuals 0.4 -0.3 0 -0.7 0.6,
// so the slope's standard error is sqrt(1.1 / 3 / 10). The quantiles of Student's t solve its
// closed form at three degrees of freedom.
const Values power_x{1, 2, 4, 8, 16}, power_y{2, 4, 16, 32, 256};

TEST(PowerLawFit, IsTheOneByHand) {
  const auto fit = fit_power_law(power_x, power_y);
  ASSERT_TRUE(fit);
  const double error = std::sqrt(1.1 / 30.0);
  constexpr double qt_0975_3 = 3.18244630528371;
  EXPECT_NEAR(fit->exponent.value, 1.7, fit_rounding);
  EXPECT_NEAR(fit->exponent.low, 1.7 - qt_0975_3 * error, fit_rounding);
  EXPECT_NEAR(fit->exponent.high, 1.7 + qt_0975_3 * error, fit_rounding);
  EXPECT_NEAR(fit->factor, std::exp2(0.6), fit_rounding);
}

TEST(PowerLawFit, WidensWithTheConfidence) {
  const auto fit = fit_power_law(power_x, power_y, 0.9);
  ASSERT_TRUE(fit);
  constexpr double qt_095_3 = 2.353363434801824;
  EXPECT_NEAR(fit->exponent.high, 1.7 + qt_095_3 * std::sqrt(1.1 / 30.0), fit_rounding);
  EXPECT_LT(width(fit->exponent), width(fit_power_law(power_x, power_y, 0.95)->exponent));
}

TEST(PowerLawFit, OfAnExactPowerHasNoWidth) {
  const Values x{1e3, 3e3, 1e4, 2e5, 1e7};
  for (const double exponent : {-2.0, 0.0, 1.0 / 3.0, 1.0, 2.5}) {
    const auto fit = fit_power_law(x, powers(x, 4e-9, exponent));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->exponent.value, exponent, fit_rounding);
    EXPECT_NEAR(width(fit->exponent), 0.0, fit_rounding);
    EXPECT_NEAR(fit->factor, 4e-9, 4e-9 * 100.0 * fit_rounding);
  }
}

TEST(PowerLawFit, KeepsItsDigitsFarFromOne) {
  // The x differ by parts in a million of 1e200: sums of squares of raw logs would lose the slope.
  Values x;
  for (int i = 0; i < 8; ++i) x.push_back(1e200 * (1.0 + 1e-6 * i));
  Values y;
  for (const double value : x) y.push_back(value / 1e200 * (value / 1e200));
  const auto fit = fit_power_law(x, y);
  ASSERT_TRUE(fit);
  // A logarithm of 460 is rounded to 6e-14, the logs spread over 7e-6.
  EXPECT_NEAR(fit->exponent.value, 2.0, 1e-7);
}

TEST(PowerLawFit, NeedsThreePointsAndTwoPlaces) {
  EXPECT_FALSE(fit_power_law({}, {}));
  EXPECT_FALSE(fit_power_law(Values{1, 2}, Values{1, 4}));
  EXPECT_TRUE(fit_power_law(Values{1, 2, 3}, Values{1, 4, 9}));
  EXPECT_TRUE(fit_power_law(Values{2, 2, 3}, Values{1, 4, 9}));
  EXPECT_FALSE(fit_power_law(Values(7, 0.1), Values{1, 2, 3, 4, 5, 6, 7}));
}

TEST(PowerLawFit, RefusesWhatHasNoLogarithm) {
  const Values good{1, 2, 3};
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(fit_power_law(good, Values{1, bad, 3}), ContractViolation) << bad;
    EXPECT_THROW(fit_power_law(Values{1, 2, bad}, good), ContractViolation) << bad;
    EXPECT_THROW(fit_power_law(Values{bad}, Values{1}), ContractViolation) << bad;
  }
}

TEST(PowerLawFit, RefusesUnpairedValuesAndImpossibleConfidences) {
  const Values three{1, 2, 3}, two{1, 2};
  EXPECT_THROW(fit_power_law(three, two), ContractViolation);
  EXPECT_THROW(fit_power_law({}, two), ContractViolation);
  for (const double confidence : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(fit_power_law(three, three, confidence), ContractViolation);
}

/// Normal errors by Box and Muller's transform.
Values with_noise(Values y, double sigma, std::uint64_t stream_index) {
  CounterStream stream(31, stream_index);
  for (double& value : y) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - stream.next_unit()));
    value *= std::exp(sigma * radius * std::cos(2.0 * std::numbers::pi * stream.next_unit()));
  }
  return y;
}

const Values power_sizes{1e3, 2e3, 5e3, 1e4, 3e4, 1e5, 1e6};

int covered_of_400(double confidence) {
  int covered = 0;
  for (std::uint64_t set = 0; set < 400; ++set) {
    const auto fit = fit_power_law(
        power_sizes, with_noise(powers(power_sizes, 2e-8, 1.3), 0.4, set), confidence);
    covered += fit && fit->exponent.low <= 1.3 && 1.3 <= fit->exponent.high;
  }
  return covered;
}

TEST(PowerLawFitLaw, CoversTheTruthAsOftenAsItSays) {
  // Binomial: 380 with a deviation of 4.4, and 200 with one of 10; four deviations each way.
  EXPECT_NEAR(covered_of_400(0.95), 380, 17);
  EXPECT_NEAR(covered_of_400(0.5), 200, 40);
}

TEST(PowerLawFitLaw, UnitsChangeOnlyTheFactor) {
  const Values y = with_noise(powers(power_sizes, 2e-8, 1.3), 0.2, 0);
  const auto fit = fit_power_law(power_sizes, y);
  ASSERT_TRUE(fit);
  for (const double factor : {1e-9, 60.0, 1e12}) {
    const auto scaled_x = fit_power_law(times(factor, power_sizes), y);
    const auto scaled_y = fit_power_law(power_sizes, times(factor, y));
    ASSERT_TRUE(scaled_x && scaled_y);
    for (const Estimate& scaled : {scaled_x->exponent, scaled_y->exponent}) {
      EXPECT_NEAR(scaled.value, fit->exponent.value, fit_rounding);
      EXPECT_NEAR(scaled.low, fit->exponent.low, fit_rounding);
      EXPECT_NEAR(scaled.high, fit->exponent.high, fit_rounding);
    }
    EXPECT_NEAR(scaled_y->factor / (factor * fit->factor), 1.0, 100.0 * fit_rounding);
    const double expected = fit->factor * std::pow(factor, -fit->exponent.value);
    EXPECT_NEAR(scaled_x->factor / expected, 1.0, 100.0 * fit_rounding);
  }
}

TEST(PowerLawFitLaw, SwappedAxesOfAnExactPowerGiveTheInverse) {
  const Values y = powers(power_sizes, 3.0, 2.5);
  const auto inverse = fit_power_law(y, power_sizes);
  ASSERT_TRUE(inverse);
  EXPECT_NEAR(inverse->exponent.value, 1.0 / 2.5, fit_rounding);
}

}  // namespace
}  // namespace phytobench
