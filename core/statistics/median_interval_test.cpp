// SPDX-License-Identifier: MIT
#include "core/statistics/median_interval.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double coverage_rounding = 1e-14;  // of the incomplete beta function

TEST(MedianCoverage, CountsTossesOfACoin) {
  EXPECT_NEAR(median_coverage(9, {2, 8}), 1.0 - 20.0 / 512.0, coverage_rounding);
  EXPECT_NEAR(median_coverage(5, {1, 5}), 1.0 - 2.0 / 32.0, coverage_rounding);
  EXPECT_NEAR(median_coverage(5, {1, 3}), 0.5 - 1.0 / 32.0, coverage_rounding);
  EXPECT_NEAR(median_coverage(2, {1, 2}), 0.5, coverage_rounding);
  EXPECT_EQ(median_coverage(7, {4, 4}), 0.0);
}

TEST(MedianCoverage, IsThatOfSimulatedSamples) {
  constexpr int sets = 4000;
  int covered = 0;
  for (std::uint64_t set = 0; set < sets; ++set) {
    CounterStream stream(40, set);
    int below = 0;
    for (int i = 0; i < 9; ++i) below += stream.next_unit() < 0.5;
    covered += 2 <= below && below < 8;
  }
  const double expected = median_coverage(9, {2, 8});
  EXPECT_NEAR(covered, sets * expected, 4.0 * std::sqrt(sets * expected * (1.0 - expected)));
}

// What R prints for qbinom(0.025, count, 0.5).
TEST(MedianRanks, AreTheTabulatedOnes) {
  struct Row {
    std::size_t count, low;
  };
  for (const Row& row : {Row{6, 1}, Row{8, 1}, Row{9, 2}, Row{11, 2}, Row{12, 3}, Row{20, 6},
                         Row{25, 8}, Row{100, 40}}) {
    const auto ranks = median_ranks(row.count);
    ASSERT_TRUE(ranks) << row.count;
    EXPECT_EQ(ranks->low, row.low) << row.count;
    EXPECT_EQ(ranks->high, row.count + 1 - row.low) << row.count;
  }
}

TEST(MedianRanks, AreMissingWhereNoneAreSureEnough) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 4u, 5u}) EXPECT_FALSE(median_ranks(count));
  EXPECT_TRUE(median_ranks(5, 0.9));
  EXPECT_FALSE(median_ranks(9, 0.999));
}

TEST(MedianRanksLaw, CoverAtLeastWhatTheySayAndNoNarrowerOnesDo) {
  for (const double confidence : {0.5, 0.8, 0.95, 0.99})
    for (std::size_t count = 1; count <= 200; ++count) {
      const auto ranks = median_ranks(count, confidence);
      if (!ranks) continue;
      EXPECT_GE(median_coverage(count, *ranks), confidence);
      if (ranks->low + 1 <= ranks->high - 1) {
        EXPECT_LT(median_coverage(count, {ranks->low + 1, ranks->high - 1}), confidence);
      }
    }
}

TEST(MedianInterval, TakesThoseRanks) {
  const auto estimate = median_interval(std::vector<double>{9, 1, 8, 2, 7, 3, 6, 4, 5});
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->value, 5.0);
  EXPECT_EQ(estimate->low, 2.0);
  EXPECT_EQ(estimate->high, 8.0);
  EXPECT_FALSE(median_interval(std::vector<double>{1, 2, 3, 4, 5}));
}

TEST(MedianIntervalLaw, FollowsAnyRisingScale) {
  CounterStream stream(41, 0);
  std::vector<double> samples, scaled;
  for (int i = 0; i < 25; ++i) {
    samples.push_back(stream.next_unit());
    scaled.push_back(std::exp(samples.back()));
  }
  EXPECT_EQ(median_interval(scaled)->low, std::exp(median_interval(samples)->low));
  EXPECT_EQ(median_interval(scaled)->high, std::exp(median_interval(samples)->high));
}

TEST(MedianInterval, RefusesImpossibleRanksAndConfidences) {
  EXPECT_THROW(median_coverage(5, {0, 5}), ContractViolation);
  EXPECT_THROW(median_coverage(5, {4, 2}), ContractViolation);
  EXPECT_THROW(median_coverage(5, {1, 6}), ContractViolation);
  EXPECT_THROW(median_ranks(5, 1.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
