// SPDX-License-Identifier: MIT
#include "core/random/counter_stream.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(RandomUnit, IsThePublishedKnownAnswerOfPhilox) {
  // Philox4x32-10 of counter 0, key 0 is 6627e8d5 e169c58d ...: the first 53 of these 64 bits.
  const double expected = static_cast<double>(0x6627e8d5e169c58dULL >> 11) * 0x1p-53;
  EXPECT_EQ(random_unit(0, 0, 0), expected);
}

TEST(RandomUnit, DependsOnSeedStreamAndIndexAlone) {
  CounterStream stream(7, 3);
  for (std::uint64_t i = 0; i < 100; ++i) EXPECT_EQ(stream.next_unit(), random_unit(7, 3, i));
  EXPECT_NE(random_unit(7, 3, 0), random_unit(8, 3, 0));
  EXPECT_NE(random_unit(7, 3, 0), random_unit(7, 4, 0));
  EXPECT_NE(random_unit(7, 3, 0), random_unit(7, 3, 1));
}

TEST(RandomOrder, HoldsEveryPlaceOnceAndReachesAllOrders) {
  std::vector<int> seen(6, 0);
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    CounterStream stream(seed, 0);
    std::vector<std::size_t> order = random_order(3, stream);
    ++seen[order[0] * 2 + (order[1] > order[2] ? 1 : 0)];
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order, (std::vector<std::size_t>{0, 1, 2}));
  }
  for (const int count : seen)
    EXPECT_GT(count, 60);  // 100 expected, 60 is more than four deviations off
}

}  // namespace
}  // namespace phytobench
