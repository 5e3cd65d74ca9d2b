// SPDX-License-Identifier: MIT
// Sums of several terms fitted to values. For one straight line see reduced_major_axis.hpp, for one
// power power_law.hpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace phytobench {

struct RegressionCoefficient {
  double value = 0.0;
  double standard_deviation = 0.0;  ///< for independent errors of equal spread in y
};

/// y = coefficients[0] + the terms times the others.
struct LinearRegression {
  std::vector<RegressionCoefficient> coefficients;  ///< first the constant
  double residual_deviation = 0.0;  ///< root of the squared residuals over the degrees of freedom
  double r_squared = 0.0;           ///< share of the scatter around the mean that is explained
};

/// Least squares by Householder's reflections, which square no condition number as normal equations
/// do, refined twice with residuals of doubled precision (Bjoerck 1967, BIT 7:257). `terms` are
/// columns as long as y. Nothing unless there are more values than coefficients, the terms are
/// independent and y is not constant; ContractViolation for values that are not finite and columns
/// of unequal length.
std::optional<LinearRegression> linear_regression(std::span<const std::vector<double>> terms,
                                                  std::span<const double> y);

/// The same for the terms x, x^2 ... x^degree; degree >= 1.
std::optional<LinearRegression> polynomial_regression(std::span<const double> x,
                                                      std::span<const double> y, int degree);

}  // namespace phytobench
