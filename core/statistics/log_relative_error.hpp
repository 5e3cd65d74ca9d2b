// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// A double has fifteen decimal digits that all survive reading and writing.
inline constexpr double most_digits = 15.0;

/// Decimal digits in which a computed number agrees with a certified one, as NIST counts them for
/// its reference data sets: -log10(|computed - certified| / |certified|), without the divisor where
/// the certified number is 0; from 0 to 15. NaN and infinity agree in none; the certified number is
/// finite, ContractViolation otherwise.
double log_relative_error(double computed, double certified);

}  // namespace phytobench
