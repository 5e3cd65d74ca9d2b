// SPDX-License-Identifier: MIT
#include "core/statistics/moments.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "core/statistics/nist_sets.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

/// Digits that must agree. What NumAcc3 and NumAcc4 lack is lost before any sum: exact arithmetic
/// on the doubles nearest to their values has 9.5 and 8.3 digits of the standard deviation.
struct Floor {
  const char* set;
  double mean, standard_deviation, lag_1_autocorrelation;
};
constexpr Floor floors[] = {{"NumAcc1", 15.0, 15.0, 15.0},
                            {"NumAcc2", 14.5, 14.0, 14.0},
                            {"NumAcc3", 14.5, 9.4, 11.5},
                            {"NumAcc4", 14.5, 8.2, 10.5}};

UnivariateSet set_named(const std::string& name) {
  for (const UnivariateSet& set : nist_univariate_sets())
    if (set.name == name) return set;
  throw std::invalid_argument(name);
}

class CertifiedMoments : public testing::TestWithParam<Floor> {};

TEST_P(CertifiedMoments, ReachTheDigits) {
  const UnivariateSet set = set_named(GetParam().set);
  EXPECT_GE(log_relative_error(mean(set.values), set.mean), GetParam().mean);
  EXPECT_GE(log_relative_error(standard_deviation(set.values), set.standard_deviation),
            GetParam().standard_deviation);
  EXPECT_GE(log_relative_error(lag_1_autocorrelation(set.values), set.lag_1_autocorrelation),
            GetParam().lag_1_autocorrelation);
}

TEST_P(CertifiedMoments, RunningOnesReachThemToo) {
  const UnivariateSet set = set_named(GetParam().set);
  RunningMoments moments;
  for (const double value : set.values) moments.add(value);
  EXPECT_GE(log_relative_error(moments.mean(), set.mean), GetParam().mean);
  EXPECT_GE(log_relative_error(moments.deviation(), set.standard_deviation),
            GetParam().standard_deviation);
}

INSTANTIATE_TEST_SUITE_P(Nist, CertifiedMoments, testing::ValuesIn(floors),
                         [](const auto& set) { return set.param.set; });

// The floors can be missed: the textbook's sum of squares less the squared sum misses them.
TEST(SumsOfSquares, MissTheFloors) {
  const UnivariateSet set = set_named("NumAcc4");
  double sum = 0.0, squares = 0.0;
  for (const double value : set.values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(set.values.size());
  const double deviation = std::sqrt((squares - sum * sum / n) / (n - 1.0));
  EXPECT_LT(log_relative_error(deviation, set.standard_deviation), 1.0);
  EXPECT_LT(log_relative_error(sum / n, set.mean), 14.5);
}

TEST(Moments, AreThoseOfTheDefinition) {
  const Values values{2, 4, 4, 4, 5, 5, 7, 9};
  EXPECT_EQ(mean(values), 5.0);
  EXPECT_EQ(variance(values), 32.0 / 7.0);
  EXPECT_EQ(centred(values).deviations, (Values{-3, -1, -1, -1, 0, 0, 2, 4}));
  EXPECT_EQ(lag_1_autocorrelation(values), 13.0 / 32.0);
  EXPECT_EQ(product_sum(values, Values(8, 0.5)), 20.0);
}

TEST(MomentsLaw, ShiftsMoveTheMeanAlone) {
  CounterStream stream(5, 0);
  Values values, shifted;
  for (int i = 0; i < 50; ++i) {
    values.push_back(std::floor(stream.next_between(-1e6, 1e6)));  // whole: exact when shifted
    shifted.push_back(values.back() + 1e12);
  }
  constexpr double rounding = 1e-4;  // of a mean near 1e12
  EXPECT_NEAR(mean(shifted), mean(values) + 1e12, rounding);
  EXPECT_NEAR(standard_deviation(shifted) / standard_deviation(values), 1.0, 1e-12);
  EXPECT_NEAR(lag_1_autocorrelation(shifted), lag_1_autocorrelation(values), 1e-9);
}

TEST(MomentsLaw, TurnedAroundTheAutocorrelationStays) {
  CounterStream stream(5, 1);
  Values values;
  for (int i = 0; i < 31; ++i) values.push_back(stream.next_unit());
  const Values turned(values.rbegin(), values.rend());
  EXPECT_NEAR(lag_1_autocorrelation(turned), lag_1_autocorrelation(values), 1e-14);
}

TEST(Moments, RefuseWhatHasNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mean({}), ContractViolation);
  EXPECT_THROW(mean(Values{1, nan}), ContractViolation);
  EXPECT_THROW(variance(Values{1}), ContractViolation);
  EXPECT_THROW(lag_1_autocorrelation(Values{3, 3, 3}), ContractViolation);
  EXPECT_THROW(product_sum(Values{1}, Values{1, 2}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
