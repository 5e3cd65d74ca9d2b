// SPDX-License-Identifier: MIT
#include "core/statistics/bootstrap.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/test_values.hpp"

namespace phytobench {
namespace {

// Few resamples keep the tests quick; what is tested does not depend on their number.
constexpr BootstrapSettings quick{.resamples = 200};

std::vector<double> uniform_samples(std::uint64_t seed, std::uint64_t stream_index,
                                    std::size_t count) {
  CounterStream stream(seed, stream_index);
  std::vector<double> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(stream.next_unit());
  return samples;
}

TEST(MedianEstimate, IntervalContainsTheMedian) {
  for (std::uint64_t set = 0; set < 3; ++set) {
    for (const std::size_t count : {10u, 40u}) {
      const std::vector<double> samples = uniform_samples(1, set, count);
      const Estimate estimate = median_estimate(samples, quick);
      EXPECT_EQ(estimate.value, median(samples));
      EXPECT_LE(estimate.low, estimate.value);
      EXPECT_GE(estimate.high, estimate.value);
      EXPECT_GT(width(estimate), 0.0);
    }
  }
}

TEST(MedianEstimate, IntervalShrinksWithMoreSamples) {
  double few = 0.0, many = 0.0;
  for (std::uint64_t set = 0; set < 3; ++set) {
    few += width(median_estimate(uniform_samples(1, set, 10), quick));
    many += width(median_estimate(uniform_samples(1, set, 400), quick));
  }
  // Widths fall with the root of the count, here to about a sixth; half leaves room for chance.
  EXPECT_LT(many, 0.5 * few);
}

TEST(MedianEstimate, IsTheSameForTheSameSettings) {
  const std::vector<double> samples = uniform_samples(2, 0, 20);
  const Estimate first = median_estimate(samples, quick);
  const Estimate second = median_estimate(samples, quick);
  EXPECT_EQ(first.value, second.value);
  EXPECT_EQ(first.low, second.low);
  EXPECT_EQ(first.high, second.high);
}

TEST(MedianEstimate, DependsOnTheSeed) {
  const std::vector<double> samples = uniform_samples(3, 0, 10);
  const Estimate first = median_estimate(samples, {.resamples = 5, .seed = 0});
  const Estimate second = median_estimate(samples, {.resamples = 5, .seed = 1});
  EXPECT_EQ(first.value, second.value);
  EXPECT_NE(first.low, second.low);
}

TEST(MedianEstimate, OfConstantSamplesHasNoWidth) {
  const Estimate estimate = median_estimate(std::vector<double>(7, 3.5), quick);
  EXPECT_EQ(estimate.value, 3.5);
  EXPECT_EQ(estimate.low, 3.5);
  EXPECT_EQ(estimate.high, 3.5);
}

TEST(MedianEstimate, WidensWithTheConfidence) {
  const std::vector<double> samples = uniform_samples(4, 0, 30);
  const Estimate narrow = median_estimate(samples, {.confidence = 0.5, .resamples = 200});
  const Estimate wide = median_estimate(samples, {.confidence = 0.99, .resamples = 200});
  EXPECT_LE(wide.low, narrow.low);
  EXPECT_GE(wide.high, narrow.high);
  EXPECT_GT(width(wide), width(narrow));
}

// The percentile bootstrap is slightly off at 15 samples and 200 data sets scatter by 1.5 %
// themselves: hence 88 to 100 % for a nominal 95.
TEST(MedianEstimate, CoversTheTrueMedianAsOftenAsItSays) {
  constexpr int data_sets = 200;
  int covered = 0;
  for (std::uint64_t set = 0; set < data_sets; ++set) {
    const Estimate estimate = median_estimate(uniform_samples(20, set, 15), quick);
    covered += estimate.low <= 0.5 && 0.5 <= estimate.high;
  }
  EXPECT_GE(covered, data_sets * 88 / 100);
}

TEST(MedianEstimate, CoversLessAtLessConfidence) {
  constexpr int data_sets = 100;
  int covered = 0;
  for (std::uint64_t set = 0; set < data_sets; ++set) {
    const Estimate estimate =
        median_estimate(uniform_samples(20, set, 15), {.confidence = 0.3, .resamples = 200});
    covered += estimate.low <= 0.5 && 0.5 <= estimate.high;
  }
  EXPECT_LE(covered, data_sets * 70 / 100);  // 30 expected, 70 is more than eight deviations off
}

TEST(MedianEstimate, RefusesWhatCannotBeEstimated) {
  const std::vector<double> samples{1, 2, 3};
  EXPECT_THROW(median_estimate({}, quick), ContractViolation);
  EXPECT_THROW(median_estimate(samples, {.resamples = 0}), ContractViolation);
  EXPECT_THROW(median_estimate(samples, {.confidence = 0.0}), ContractViolation);
  EXPECT_THROW(median_estimate(samples, {.confidence = 1.0}), ContractViolation);
}

TEST(MedianEstimateLaw, ScalesWithTheSamples) {
  const std::vector<double> samples = uniform_samples(6, 0, 15);
  const Estimate estimate = median_estimate(samples, quick);
  const Estimate scaled =
      median_estimate(times(8.0, samples), quick);  // a power of two: no rounding
  EXPECT_EQ(scaled.value, 8.0 * estimate.value);
  EXPECT_EQ(scaled.low, 8.0 * estimate.low);
  EXPECT_EQ(scaled.high, 8.0 * estimate.high);
}

}  // namespace
}  // namespace phytobench
