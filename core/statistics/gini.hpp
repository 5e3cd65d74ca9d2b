// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace phytobench {

/// How unequal sizes are: the mean of |x_i - x_j| over all n^2 pairs, a value with itself included,
/// over twice the mean. From 0, where all are equal, to 1 - 1/n, where one has everything; the form
/// for a sample, n / (n - 1) times as large, is not taken. In n log n; the same for any order of
/// the values. 0 if all are 0. Throws ContractViolation for no values and for values that are
/// negative or not finite.
double gini_coefficient(std::span<const double> values);

struct LorenzPoint {
  double share_of_number = 0.0;  ///< of the values, the smallest first
  double share_of_sum = 0.0;     ///< that those make up together
};

/// From (0, 0) to (1, 1), n + 1 points. The area between it and the diagonal is half of the
/// coefficient. Throws ContractViolation as above, and if all values are 0.
std::vector<LorenzPoint> lorenz_curve(std::span<const double> values);

}  // namespace phytobench
