// SPDX-License-Identifier: MIT
#include "core/random/subtractive_stream.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(SubtractiveStream, StartsWithThePublishedNumbers) {
  SubtractiveStream stream(0);
  EXPECT_NEAR(stream.next_unit(), 0.726243269967960, 5e-16);
  EXPECT_NEAR(stream.next_unit(), 0.817325359590969, 5e-16);
}

TEST(SubtractiveStream, StaysInsideTheUnitIntervalForAnySeed) {
  for (const std::uint64_t seed : {0u, 1u, 161803398u, 161803399u, 2147483647u}) {
    SubtractiveStream stream(seed);
    for (int i = 0; i < 10000; ++i) {
      const double u = stream.next_unit();
      ASSERT_GE(u, 0.0) << "seed " << seed << ", number " << i;
      ASSERT_LT(u, 1.0) << "seed " << seed << ", number " << i;
    }
  }
}

TEST(SubtractiveStream, RefusesSeedsTheOriginalCannotTake) {
  EXPECT_THROW(SubtractiveStream(2147483648u), ContractViolation);
}

}  // namespace
}  // namespace phytobench
