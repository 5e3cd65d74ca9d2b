// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// y = factor * x^exponent.
struct PowerLaw {
  Estimate exponent;    ///< with its confidence interval
  double factor = 0.0;  ///< y at x = 1, often far outside the data; in units of y
};

/// Ordinary least squares of log y on log x. The exponent's interval is Student's with n - 2
/// degrees of freedom: it holds for independent, normal errors of equal spread in log y, and knows
/// nothing of a curve that is no power. Nothing for fewer than three points or if all x are equal;
/// throws ContractViolation for values that are not positive and finite and for spans of unequal
/// size.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y,
                                      double confidence = 0.95);

}  // namespace phytobench
