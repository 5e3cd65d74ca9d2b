// SPDX-License-Identifier: MIT
#include "core/statistics/binomial_interval.hpp"

#include <boost/math/special_functions/beta.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

Estimate share_estimate(std::int64_t successes, std::int64_t trials, double confidence) {
  PHYTOBENCH_EXPECT(trials > 0 && 0 <= successes && successes <= trials);
  PHYTOBENCH_EXPECT(confidence > 0.0 && confidence < 1.0);
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  const double tail = 0.5 * (1.0 - confidence);
  return {k / n, successes == 0 ? 0.0 : boost::math::ibeta_inv(k, n - k + 1.0, tail),
          successes == trials ? 1.0 : boost::math::ibetac_inv(k + 1.0, n - k, tail)};
}

}  // namespace phytobench
