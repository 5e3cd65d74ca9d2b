// SPDX-License-Identifier: MIT
#include "core/statistics/midranks.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Ranks = std::vector<std::int64_t>;

TEST(DoubledMidranks, AreTheOnesByHand) {
  EXPECT_EQ(doubled_midranks({}), Ranks{});
  EXPECT_EQ(doubled_midranks(std::vector<double>{30, 10, 20}), (Ranks{6, 2, 4}));
  EXPECT_EQ(doubled_midranks(std::vector<double>{5, 1, 5, 7}), (Ranks{5, 2, 5, 8}));
  EXPECT_EQ(doubled_midranks(std::vector<double>{2, 2, 2}), (Ranks{4, 4, 4}));
  EXPECT_EQ(doubled_midranks(std::vector<double>{0.0, -0.0}), (Ranks{3, 3}));
}

TEST(DoubledMidranks, TakeInfinity) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(doubled_midranks(std::vector<double>{infinity, 1, -infinity}), (Ranks{6, 4, 2}));
}

TEST(DoubledMidranks, RefuseWhatHasNoOrder) {
  EXPECT_THROW(doubled_midranks(std::vector<double>{1, NAN}), ContractViolation);
}

TEST(DoubledMidranksLaw, AddUpToTheSameWhateverIsTied) {
  for (std::uint64_t set = 0; set < 50; ++set) {
    CounterStream stream(51, set);
    std::vector<double> values(20);
    for (double& value : values) value = std::floor(8.0 * stream.next_unit());
    const Ranks ranks = doubled_midranks(values);
    EXPECT_EQ(std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0}), 20 * 21);
  }
}

}  // namespace
}  // namespace phytobench
