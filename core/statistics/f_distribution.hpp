// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// Degrees of freedom of the F distribution; both above 0, they need not be whole.
struct FDegrees {
  double numerator = 1.0;
  double denominator = 1.0;
};

/// Probability that an F-distributed value is at most x; x >= 0, infinity gives 1.
double f_probability(double x, const FDegrees& degrees);

/// Probability that it is above x; not by subtraction, so small ones are accurate, too.
double f_tail(double x, const FDegrees& degrees);

/// The value that it stays at or below with this probability; `probability` in [0, 1), 0 gives 0.
double f_quantile(double probability, const FDegrees& degrees);

// ContractViolation for all else, NaN included.

}  // namespace phytobench
