// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// How large a change a ratio's interval leaves no doubt of, as a share of the quicker side: 0.03
/// for [1.03, 1.2] and for [1 / 1.2, 1 / 1.03], 0 where the interval holds 1. Positive ends.
inline double least_change(const Estimate& ratio) {
  return std::max({0.0, ratio.low - 1.0, 1.0 / ratio.high - 1.0});
}

/// How large a change the interval does not exclude: 0.2 for both of these.
inline double largest_change(const Estimate& ratio) {
  return std::max({0.0, ratio.high - 1.0, 1.0 / ratio.low - 1.0});
}

}  // namespace phytobench
