// SPDX-License-Identifier: MIT
// Straight lines through points of which both coordinates scatter, such as the logarithms of
// density and mean weight of thinning stands.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace phytobench {

/// y = intercept + slope * x.
struct StraightLine {
  double slope = 0.0;
  double slope_error = 0.0;  ///< standard error of the slope, with n - 2 degrees of freedom
  double intercept = 0.0;
  double r_squared = 0.0;  ///< square of Pearson's correlation: the same for both lines below
  std::size_t points = 0;
};

/// The line of least vertical squares. Its slope is `r` times that of the reduced major axis: it
/// leans to the horizontal if x scatters, too. Nothing for fewer than three points or where all x
/// or all y are equal; throws ContractViolation for values that are not finite and for spans of
/// unequal length.
std::optional<StraightLine> least_squares_line(std::span<const double> x,
                                               std::span<const double> y);

/// The reduced (standardised) major axis: the ratio of both standard deviations with the sign of
/// the covariance, through the means. Treats both axes alike: swapped, its slope is the inverse.
/// The standard error is that of least squares (McArdle 1988, Can. J. Zool. 66:2329), which holds
/// for a two-dimensional normal scatter. Nothing as above, and if the covariance is 0.
std::optional<StraightLine> reduced_major_axis(std::span<const double> x,
                                               std::span<const double> y);

}  // namespace phytobench
