// SPDX-License-Identifier: MIT
#include "core/statistics/binomial_interval.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

// What R prints for binom.test(...)$conf.int.
TEST(ShareEstimate, IsTheTabulatedOne) {
  constexpr double printed = 1e-12;
  const Estimate one_of_ten = share_estimate(1, 10);
  EXPECT_EQ(one_of_ten.value, 0.1);
  EXPECT_NEAR(one_of_ten.low, 0.00252857854446, printed);
  EXPECT_NEAR(one_of_ten.high, 0.44501611702820, printed);
  const Estimate most = share_estimate(950, 1000);
  EXPECT_NEAR(most.low, 0.934609512085, printed);
  EXPECT_NEAR(most.high, 0.962664602395, printed);
}

TEST(ShareEstimate, HasClosedFormsAtTheEnds) {
  const Estimate none = share_estimate(0, 12), all = share_estimate(12, 12);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 1.0 / 12.0), 1e-14);
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 12.0), 1e-14);
  EXPECT_EQ(all.high, 1.0);
}

TEST(ShareEstimateLaw, FailuresMirrorSuccesses) {
  for (const std::int64_t successes : {0, 3, 50, 97, 100}) {
    const Estimate share = share_estimate(successes, 100);
    const Estimate mirrored = share_estimate(100 - successes, 100);
    EXPECT_NEAR(share.low, 1.0 - mirrored.high, 1e-13);
    EXPECT_NEAR(share.high, 1.0 - mirrored.low, 1e-13);
    EXPECT_LE(share.low, share.value);
    EXPECT_LE(share.value, share.high);
  }
}

TEST(ShareEstimate, RefusesImpossibleCounts) {
  EXPECT_THROW(share_estimate(0, 0), ContractViolation);
  EXPECT_THROW(share_estimate(-1, 3), ContractViolation);
  EXPECT_THROW(share_estimate(4, 3), ContractViolation);
  EXPECT_THROW(share_estimate(1, 3, 0.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
