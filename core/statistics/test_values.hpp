// SPDX-License-Identifier: MIT
// What tests of estimates do with samples and intervals.
#pragma once

#include <vector>

#include "core/statistics/estimate.hpp"

namespace phytobench {

inline double width(const Estimate& estimate) {
  return estimate.high - estimate.low;
}

inline std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace phytobench
