// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace phytobench {

/// Quantile by linear interpolation between order statistics (Hyndman and Fan's type 7, the default
/// of R and NumPy). `values` need no order and must not be empty; `probability` in [0, 1].
double quantile(std::span<const double> values, double probability);

/// quantile(values, 0.5).
double median(std::span<const double> values);

}  // namespace phytobench
