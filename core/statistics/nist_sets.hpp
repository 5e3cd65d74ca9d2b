// SPDX-License-Identifier: MIT
// Statistical Reference Datasets of the National Institute of Standards and Technology (NIST StRD,
// https://www.itl.nist.gov/div898/strd/): data with answers that were certified in arithmetic of
// 500 digits, to certify programs with. Here are those that were made by a formula, and one
// observed set for the straight line.
#pragma once

#include <string>
#include <vector>

#include "core/statistics/linear_regression.hpp"

namespace phytobench {

/// NumAcc1 to NumAcc4 (Simon and Lesage 1989, Comput. Stat. Data Anal. 8:325): values that differ
/// in their last printed digit only. What is certified is exact for the decimal numbers; as
/// doubles all but NumAcc1 are other numbers, which limits how many digits any program can reach.
struct UnivariateSet {
  std::string name;  ///< as NIST spells it
  std::vector<double> values;
  double mean = 0.0;
  double standard_deviation = 0.0;
  double lag_1_autocorrelation = 0.0;
};

std::vector<UnivariateSet> nist_univariate_sets();

/// Norris (calibration of ozone monitors, a straight line) and Wampler1 to Wampler5 (1970, J. Am.
/// Stat. Assoc. 65:549), polynomials of degree 5: exact in the first two, with residuals that grow
/// a hundredfold from each of the others to the next.
struct RegressionSet {
  std::string name;
  int degree = 1;
  std::vector<double> x, y;
  std::vector<RegressionCoefficient> coefficients;  ///< certified, first the constant
  double residual_deviation = 0.0;
  double r_squared = 0.0;
};

std::vector<RegressionSet> nist_regression_sets();

}  // namespace phytobench
