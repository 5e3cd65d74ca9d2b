// SPDX-License-Identifier: MIT
#include "core/statistics/chi_square.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Counts = std::vector<std::int64_t>;

Counts random_counts(std::uint64_t stream_index, std::size_t cells, int draws) {
  CounterStream stream(9, stream_index);
  Counts counts(cells, 0);
  for (int i = 0; i < draws; ++i)
    ++counts[static_cast<std::size_t>(stream.next_unit() * static_cast<double>(cells))];
  return counts;
}

TEST(UniformityPValue, IsTheTabulatedOne) {
  constexpr double rounding = 1e-14;
  EXPECT_EQ(uniformity_p_value(Counts{50, 50}), 1.0);
  // Chi-square 4 at one degree of freedom: erfc(sqrt(2)).
  EXPECT_NEAR(uniformity_p_value(Counts{60, 40}), 0.0455002638963584, rounding);
  // Chi-square 10 at two degrees of freedom: exp(-5).
  EXPECT_NEAR(uniformity_p_value(Counts{10, 20, 30}), 0.006737946999085467, rounding);
}

TEST(UniformityPValue, HasAClosedFormForThreeCells) {
  constexpr double rounding = 1e-12;  // relative; of the incomplete gamma function
  for (std::uint64_t set = 0; set < 50; ++set) {
    const Counts counts = random_counts(set, 3, 60);
    double statistic = 0.0;
    for (const std::int64_t count : counts) {
      const double excess = static_cast<double>(count) - 20.0;
      statistic += excess * excess / 20.0;
    }
    const double expected = std::exp(-0.5 * statistic);
    EXPECT_NEAR(uniformity_p_value(counts), expected, rounding * expected) << "set " << set;
  }
}

TEST(UniformityPValue, OfUniformCountsIsItselfUniform) {
  int alarms = 0;
  for (std::uint64_t set = 0; set < 200; ++set)
    alarms += uniformity_p_value(random_counts(set, 7, 140)) < 0.1;
  // 20 of 200 expected with a deviation of 4.2.
  EXPECT_GE(alarms, 4);
  EXPECT_LE(alarms, 40);
}

TEST(UniformityPValue, OfCountsInOneCellIsTiny) {
  EXPECT_LT(uniformity_p_value(Counts{100, 0, 0, 0}), 1e-30);
  EXPECT_GT(uniformity_p_value(Counts{26, 24, 25, 25}), 0.9);
}

TEST(UniformityPValue, RefusesLessThanTwoCellsAndNoCounts) {
  EXPECT_THROW(uniformity_p_value({}), ContractViolation);
  EXPECT_THROW(uniformity_p_value(Counts{5}), ContractViolation);
  EXPECT_THROW(uniformity_p_value(Counts{0, 0}), ContractViolation);
}

TEST(UniformityPValueLaw, OrderOfCellsDoesNotMatter) {
  Counts counts{10, 20, 30, 20};  // every term of the statistic is exact
  const double p_value = uniformity_p_value(counts);
  std::sort(counts.begin(), counts.end());
  do {
    EXPECT_EQ(uniformity_p_value(counts), p_value);
  } while (std::next_permutation(counts.begin(), counts.end()));
}

}  // namespace
}  // namespace phytobench
