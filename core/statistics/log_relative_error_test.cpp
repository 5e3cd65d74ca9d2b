// SPDX-License-Identifier: MIT
#include "core/statistics/log_relative_error.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double digit_rounding = 1e-9;  // of a logarithm of a difference

TEST(LogRelativeError, CountsDecimalDigits) {
  EXPECT_NEAR(log_relative_error(1.001, 1.0), 3.0, digit_rounding);
  EXPECT_NEAR(log_relative_error(-2000.2, -2000.0), 4.0, digit_rounding);
  EXPECT_NEAR(log_relative_error(5.0, 4.0), std::log10(4.0), digit_rounding);
}

TEST(LogRelativeError, IsAbsoluteWhereTheCertifiedNumberIsZero) {
  EXPECT_NEAR(log_relative_error(1e-7, 0.0), 7.0, digit_rounding);
  EXPECT_EQ(log_relative_error(-1e-40, 0.0), most_digits);
  EXPECT_EQ(log_relative_error(0.0, 0.0), most_digits);
}

TEST(LogRelativeError, LiesBetweenNoneAndFifteen) {
  EXPECT_EQ(log_relative_error(0.1, 0.1), most_digits);
  EXPECT_EQ(log_relative_error(std::nextafter(0.1, 1.0), 0.1), most_digits);
  EXPECT_EQ(log_relative_error(-3.0, 3.0), 0.0);
  EXPECT_EQ(log_relative_error(2e9, 1.0), 0.0);
  EXPECT_EQ(log_relative_error(std::numeric_limits<double>::quiet_NaN(), 1.0), 0.0);
  EXPECT_EQ(log_relative_error(std::numeric_limits<double>::infinity(), 1.0), 0.0);
  EXPECT_THROW(log_relative_error(1.0, std::numeric_limits<double>::quiet_NaN()),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
