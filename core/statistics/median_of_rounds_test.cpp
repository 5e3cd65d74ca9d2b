// SPDX-License-Identifier: MIT
#include "core/statistics/median_of_rounds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/median_interval.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {
namespace {

/// Skewed, as times are: never shorter than 1, seldom much longer.
std::vector<double> skewed_times(std::uint64_t set, std::size_t rounds) {
  CounterStream stream(50, set);
  std::vector<double> samples;
  for (std::size_t i = 0; i < rounds; ++i)
    samples.push_back(1.0 - std::log(1.0 - stream.next_unit()));
  return samples;
}

/// In how many of `sets` sets the ends enclose the true median.
int times_enclosed(std::size_t rounds, int sets) {
  const double truth = 1.0 + std::log(2.0);
  int enclosed = 0;
  for (int set = 0; set < sets; ++set) {
    const MedianOfRounds found =
        median_of_rounds(skewed_times(static_cast<std::uint64_t>(set), rounds));
    enclosed += found.low <= truth && truth <= found.high;
  }
  return enclosed;
}

TEST(MedianOfRounds, KnowsFromHowManyRoundsOnThereIsAnInterval) {
  EXPECT_FALSE(median_ranks(fewest_rounds - 1));
  EXPECT_TRUE(median_ranks(fewest_rounds));
  for (std::size_t rounds = 1; rounds <= 25; ++rounds) {
    const MedianOfRounds found = median_of_rounds(skewed_times(0, rounds));
    EXPECT_EQ(found.rounds, rounds);
    EXPECT_EQ(found.is_only_range(), rounds < fewest_rounds);
  }
  EXPECT_FALSE(MedianOfRounds{}.is_only_range()) << "what was not timed in rounds is exact";
}

TEST(MedianOfRoundsLaw, EnclosesTheMedianAsOftenAsItsRanksSay) {
  constexpr int sets = 4000;
  for (const std::size_t rounds : {6u, 7u, 9u, 12u, 25u}) {
    const double expected = median_coverage(rounds, *median_ranks(rounds));
    EXPECT_GE(expected, 0.95);
    EXPECT_NEAR(times_enclosed(rounds, sets), sets * expected,
                4.0 * std::sqrt(sets * expected * (1.0 - expected)))
        << rounds;
  }
}

// Why a range is called so: that of three rounds misses one median in four.
TEST(MedianOfRoundsLaw, ARangeEnclosesTheMedianTooSeldom) {
  constexpr int sets = 4000;
  for (const std::size_t rounds : {1u, 2u, 3u, 5u}) {
    const double expected = 1.0 - std::exp2(1.0 - static_cast<double>(rounds));
    EXPECT_LT(expected, 0.95);
    EXPECT_NEAR(times_enclosed(rounds, sets), sets * expected,
                4.0 * std::sqrt(sets * expected * (1.0 - expected)) + 0.5)
        << rounds;
  }
}

TEST(MedianOfRoundsLaw, KnowsNoOrderOfRounds) {
  for (const std::size_t rounds : {3u, 8u, 9u}) {
    std::vector<double> samples = skewed_times(1, rounds);
    const MedianOfRounds first = median_of_rounds(samples);
    std::reverse(samples.begin(), samples.end());
    const MedianOfRounds second = median_of_rounds(samples);
    EXPECT_EQ(first.value, second.value);
    EXPECT_EQ(first.low, second.low);
    EXPECT_EQ(first.high, second.high);
  }
}

TEST(MedianOfRoundsLaw, ScalesWithTheSamplesAndHoldsTheirMedian) {
  for (const std::size_t rounds : {2u, 5u, 6u, 15u}) {
    const std::vector<double> samples = skewed_times(2, rounds);
    std::vector<double> scaled = samples;
    for (double& value : scaled) value *= 8.0;  // a power of two: no rounding
    const MedianOfRounds found = median_of_rounds(samples), larger = median_of_rounds(scaled);
    EXPECT_EQ(found.value, median(samples));
    EXPECT_LE(found.low, found.value);
    EXPECT_LE(found.value, found.high);
    EXPECT_EQ(larger.value, 8.0 * found.value);
    EXPECT_EQ(larger.low, 8.0 * found.low);
    EXPECT_EQ(larger.high, 8.0 * found.high);
  }
}

TEST(MedianOfRounds, OfFewRoundsEndsAtTheExtremes) {
  const MedianOfRounds found = median_of_rounds(std::vector<double>{2.0, 9.0, 3.0});
  EXPECT_EQ(found.value, 3.0);
  EXPECT_EQ(found.low, 2.0);
  EXPECT_EQ(found.high, 9.0);
}

TEST(RatioOfRounds, OfAMultipleIsExactlyThatMultiple) {
  const std::vector<double> denominator = skewed_times(3, 12);
  std::vector<double> numerator = denominator;
  for (double& value : numerator) value *= 4.0;
  const MedianOfRounds ratio = ratio_of_rounds(numerator, denominator);
  EXPECT_EQ(ratio.value, 4.0);
  EXPECT_EQ(ratio.low, 4.0);
  EXPECT_EQ(ratio.high, 4.0);
  EXPECT_EQ(ratio.rounds, 12u);
}

// A round in which the whole machine was slow leaves no trace.
TEST(RatioOfRoundsLaw, BearsWhatBothShare) {
  std::vector<double> numerator{2, 4, 6, 8, 10, 12}, denominator{1, 2, 3, 4, 5, 6};
  numerator[2] *= 128.0;
  denominator[2] *= 128.0;
  EXPECT_EQ(ratio_of_rounds(numerator, denominator).low, 2.0);
  EXPECT_EQ(ratio_of_rounds(numerator, denominator).high, 2.0);
}

TEST(MedianOfRounds, RefusesNothingAndWhatHasNoPartner) {
  const std::vector<double> three{1, 2, 3}, two{1, 2};
  EXPECT_THROW(median_of_rounds({}), ContractViolation);
  EXPECT_THROW(ratio_of_rounds(three, two), ContractViolation);
  EXPECT_THROW(ratio_of_rounds({}, {}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
