// SPDX-License-Identifier: MIT
// Mean, spread and autocorrelation of values that lie in memory. For values that come one by one,
// see running_moments.hpp.
#pragma once

#include <span>
#include <vector>

namespace phytobench {

/// Values as deviations from their mean.
struct CentredValues {
  double mean = 0.0;
  std::vector<double> deviations;  ///< in the order of the values
};

/// Takes the mean off values. It is summed from differences to the first value: no digits are lost
/// where values are large and lie close together. ContractViolation for no values and for values
/// that are not finite, as for all functions below.
CentredValues centred(std::span<const double> values);

/// Sum of the products of two series, term by term from the first; of one length.
double product_sum(std::span<const double> first, std::span<const double> second);

double mean(std::span<const double> values);

/// Of the population that a sample is from: divided by one less than the number of values; at
/// least two. In two passes, the second corrected for the rounding of the mean (Chan, Golub and
/// LeVeque 1983, The American Statistician 37:242).
double variance(std::span<const double> values);

/// Root of variance().
double standard_deviation(std::span<const double> values);

/// Correlation of each value with the next as NIST certifies it: both are deviations from the mean
/// of all values, and the sum of n - 1 products is divided by that of all n squares. Values of
/// which two differ; ContractViolation otherwise.
double lag_1_autocorrelation(std::span<const double> values);

}  // namespace phytobench
