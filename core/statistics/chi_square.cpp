// SPDX-License-Identifier: MIT
#include "core/statistics/chi_square.hpp"

#include <numeric>

#include <boost/math/special_functions/gamma.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

double uniformity_p_value(std::span<const std::int64_t> counts) {
  const auto total =
      static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
  PHYTOBENCH_EXPECT(counts.size() >= 2 && total > 0);
  const double expected = total / static_cast<double>(counts.size());
  double statistic = 0.0;
  for (const std::int64_t count : counts) {
    const double excess = static_cast<double>(count) - expected;
    statistic += excess * excess / expected;
  }
  const double degrees_of_freedom = static_cast<double>(counts.size() - 1);
  return boost::math::gamma_q(0.5 * degrees_of_freedom, 0.5 * statistic);
}

}  // namespace phytobench
