// SPDX-License-Identifier: MIT
#include "core/statistics/linear_regression.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "core/statistics/nist_sets.hpp"
#include "core/statistics/power_law.hpp"
#include "core/statistics/reduced_major_axis.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

double fewest_digits(const LinearRegression& fit, const RegressionSet& set) {
  double digits = std::min(log_relative_error(fit.residual_deviation, set.residual_deviation),
                           log_relative_error(fit.r_squared, set.r_squared));
  for (std::size_t j = 0; j < set.coefficients.size(); ++j) {
    const RegressionCoefficient& certified = set.coefficients[j];
    digits = std::min(
        {digits, log_relative_error(fit.coefficients[j].value, certified.value),
         log_relative_error(fit.coefficients[j].standard_deviation, certified.standard_deviation)});
  }
  return digits;
}

class CertifiedRegression : public testing::TestWithParam<RegressionSet> {};

// Certified values have fifteen digits, the last of them rounded; the deviations of Wampler2's
// coefficients are those of its values as doubles.
TEST_P(CertifiedRegression, ReachesThirteenDigits) {
  const auto fit = polynomial_regression(GetParam().x, GetParam().y, GetParam().degree);
  ASSERT_TRUE(fit);
  EXPECT_GE(fewest_digits(*fit, GetParam()), 13.0);
}

INSTANTIATE_TEST_SUITE_P(Nist, CertifiedRegression, testing::ValuesIn(nist_regression_sets()),
                         [](const auto& set) { return set.param.name; });

/// The textbook's way: X^T X b = X^T y by Gauss without exchanges.
Values by_normal_equations(const RegressionSet& set) {
  const std::size_t n = set.coefficients.size();
  std::vector<Values> a(n, Values(n + 1, 0.0));
  for (std::size_t row = 0; row < set.x.size(); ++row)
    for (std::size_t i = 0; i < n; ++i) {
      const double left = std::pow(set.x[row], static_cast<double>(i));
      for (std::size_t j = 0; j < n; ++j)
        a[i][j] += left * std::pow(set.x[row], static_cast<double>(j));
      a[i][n] += left * set.y[row];
    }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = n + 1; j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
  Values b(n);
  for (std::size_t k = n; k-- > 0;) {
    b[k] = a[k][n];
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

TEST(NormalEquations, MissTheFloor) {
  for (const RegressionSet& set : nist_regression_sets()) {
    if (set.degree == 1) continue;
    double digits = most_digits;
    const Values b = by_normal_equations(set);
    for (std::size_t j = 0; j < b.size(); ++j)
      digits = std::min(digits, log_relative_error(b[j], set.coefficients[j].value));
    EXPECT_LT(digits, 12.0) << set.name;
  }
}

// The straight lines of the suite, certified on the same set; the intercept is a difference of
// numbers sixteen hundred times as large.
TEST(CertifiedLines, ReachTheDigits) {
  const RegressionSet set = nist_regression_sets()[0];
  ASSERT_EQ(set.name, "Norris");
  const auto line = least_squares_line(set.x, set.y);
  ASSERT_TRUE(line);
  EXPECT_GE(log_relative_error(line->slope, set.coefficients[1].value), 13.0);
  EXPECT_GE(log_relative_error(line->slope_error, set.coefficients[1].standard_deviation), 13.0);
  EXPECT_GE(log_relative_error(line->intercept, set.coefficients[0].value), 11.5);
  EXPECT_GE(log_relative_error(line->r_squared, set.r_squared), 14.0);

  Values x, y;
  for (const double value : set.x) x.push_back(std::exp(0.5 * value));
  for (const double value : set.y) y.push_back(std::exp(0.5 * value));
  const auto law = fit_power_law(x, y);
  ASSERT_TRUE(law);
  constexpr double qt_0975_34 = 2.032244509317719;  // R: qt(0.975, 34)
  const double half_width = qt_0975_34 * set.coefficients[1].standard_deviation;
  EXPECT_GE(log_relative_error(law->exponent.value, set.coefficients[1].value), 13.0);
  EXPECT_GE(log_relative_error(0.5 * (law->exponent.high - law->exponent.low), half_width), 11.5);
}

TEST(LinearRegression, IsTheOneByHand) {
  // y = 1 + 2 a - b and residuals 1, -1, -1, 1, orthogonal to all terms.
  const std::vector<Values> terms{{0, 0, 1, 1}, {0, 1, 0, 1}};
  const auto fit = linear_regression(terms, Values{2, -1, 2, 3});
  ASSERT_TRUE(fit);
  constexpr double rounding = 1e-14;
  EXPECT_NEAR(fit->coefficients[0].value, 1.0, rounding);
  EXPECT_NEAR(fit->coefficients[1].value, 2.0, rounding);
  EXPECT_NEAR(fit->coefficients[2].value, -1.0, rounding);
  EXPECT_NEAR(fit->residual_deviation, 2.0, rounding);
  EXPECT_NEAR(fit->coefficients[0].standard_deviation, std::sqrt(3.0), rounding);
  EXPECT_NEAR(fit->coefficients[1].standard_deviation, 2.0, rounding);
  EXPECT_NEAR(fit->r_squared, 1.0 - 4.0 / 9.0, rounding);
}

TEST(LinearRegression, NeedsIndependentTermsAndDegreesOfFreedom) {
  const Values y{1, 4, 2, 8, 5};
  EXPECT_FALSE(linear_regression(std::vector<Values>{{3, 3, 3, 3, 3}}, y)) << "the constant again";
  EXPECT_FALSE(linear_regression(std::vector<Values>{{1, 2, 3, 4, 6}, {2, 4, 6, 8, 12}}, y));
  EXPECT_FALSE(polynomial_regression(Values{1, 2, 3}, Values{1, 4, 2}, 2));
  EXPECT_FALSE(polynomial_regression(Values{1, 2, 3, 4}, Values{7, 7, 7, 7}, 1));
  EXPECT_TRUE(polynomial_regression(Values{1, 2, 3, 4}, Values{7, 7, 8, 7}, 2));
}

TEST(LinearRegression, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Values y{1, 4, 2, 8};
  EXPECT_THROW(linear_regression(std::vector<Values>{{1, 2, nan, 4}}, y), ContractViolation);
  EXPECT_THROW(linear_regression(std::vector<Values>{{1, 2, 3}}, y), ContractViolation);
  EXPECT_THROW(polynomial_regression(y, Values{1, 2, 3, nan}, 1), ContractViolation);
  EXPECT_THROW(polynomial_regression(y, y, 0), ContractViolation);
}

TEST(LinearRegressionLaw, WithOneTermIsTheStraightLine) {
  CounterStream stream(8, 0);
  Values x, y;
  for (int i = 0; i < 30; ++i) {
    x.push_back(stream.next_between(-5, 20));
    y.push_back(3.0 - 0.7 * x.back() + stream.next_unit());
  }
  const auto fit = polynomial_regression(x, y, 1);
  const auto line = least_squares_line(x, y);
  ASSERT_TRUE(fit && line);
  constexpr double rounding = 1e-13;
  EXPECT_NEAR(fit->coefficients[1].value, line->slope, rounding);
  EXPECT_NEAR(fit->coefficients[0].value, line->intercept, rounding);
  EXPECT_NEAR(fit->coefficients[1].standard_deviation, line->slope_error, rounding);
  EXPECT_NEAR(fit->r_squared, line->r_squared, rounding);
}

TEST(LinearRegressionLaw, OrderOfTermsAndRowsDoesNotMatter) {
  CounterStream stream(8, 1);
  std::vector<Values> terms(2);
  Values y;
  for (int i = 0; i < 20; ++i) {
    for (Values& term : terms) term.push_back(stream.next_unit());
    y.push_back(stream.next_unit());
  }
  const auto fit = linear_regression(terms, y);
  std::swap(terms[0], terms[1]);
  for (Values& term : terms) std::reverse(term.begin(), term.end());
  std::reverse(y.begin(), y.end());
  const auto swapped = linear_regression(terms, y);
  ASSERT_TRUE(fit && swapped);
  EXPECT_NEAR(fit->coefficients[1].value, swapped->coefficients[2].value, 1e-13);
  EXPECT_NEAR(fit->coefficients[2].value, swapped->coefficients[1].value, 1e-13);
  EXPECT_NEAR(fit->residual_deviation, swapped->residual_deviation, 1e-13);
}

}  // namespace
}  // namespace phytobench
