// SPDX-License-Identifier: MIT
#include "core/statistics/log_relative_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

double log_relative_error(double computed, double certified) {
  PHYTOBENCH_EXPECT(std::isfinite(certified));
  if (computed == certified) return most_digits;
  if (!std::isfinite(computed)) return 0.0;
  const double scale = certified == 0.0 ? 1.0 : std::abs(certified);
  const double digits = -std::log10(std::abs(computed - certified) / scale);
  return std::min(std::max(0.0, digits), most_digits);  // 0 without a sign
}

}  // namespace phytobench
