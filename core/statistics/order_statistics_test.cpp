// SPDX-License-Identifier: MIT
#include "core/statistics/order_statistics.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

std::vector<double> uniform_samples(std::uint64_t stream_index, std::size_t count) {
  CounterStream stream(1, stream_index);
  std::vector<double> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(stream.next_between(-10.0, 10.0));
  return samples;
}

// What R prints for quantile(c(1, 2, 3, 4), ..., type = 7).
TEST(Quantile, IsHyndmanAndFansTypeSeven) {
  const std::vector<double> values{4, 1, 3, 2};
  EXPECT_DOUBLE_EQ(quantile(values, 0.1), 1.3);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(values, 0.75), 3.25);
  EXPECT_DOUBLE_EQ(quantile(std::vector<double>{1, 2, 3, 4, 5, 10}, 0.9), 7.5);
}

TEST(Quantile, EndsAtTheExtremes) {
  const std::vector<double> values = uniform_samples(0, 37);
  EXPECT_EQ(quantile(values, 0.0), *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(quantile(values, 1.0), *std::max_element(values.begin(), values.end()));
}

TEST(Quantile, OfOneValueIsThatValue) {
  const std::vector<double> value{-2.5};
  for (const double probability : {0.0, 0.3, 1.0}) EXPECT_EQ(quantile(value, probability), -2.5);
}

TEST(Quantile, RefusesNothingAndImpossibleProbabilities) {
  const std::vector<double> values{1, 2, 3};
  EXPECT_THROW(quantile({}, 0.5), ContractViolation);
  EXPECT_THROW(quantile(values, -0.01), ContractViolation);
  EXPECT_THROW(quantile(values, 1.01), ContractViolation);
  EXPECT_THROW(quantile(values, std::numeric_limits<double>::quiet_NaN()), ContractViolation);
}

TEST(Median, IsTheMiddleValueOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median(std::vector<double>{9, 1, 5}), 5.0);
  EXPECT_EQ(median(std::vector<double>{9, 1, 5, 6}), 5.5);
  EXPECT_THROW(median({}), ContractViolation);
}

TEST(QuantileLaw, OrderOfValuesDoesNotMatter) {
  const std::vector<double> values = uniform_samples(1, 25);
  CounterStream stream(2, 0);
  for (int i = 0; i < 20; ++i) {
    std::vector<double> shuffled;
    for (const std::size_t place : random_order(values.size(), stream))
      shuffled.push_back(values[place]);
    for (const double probability : {0.0, 0.11, 0.5, 0.97})
      ASSERT_EQ(quantile(shuffled, probability), quantile(values, probability));
  }
}

TEST(QuantileLaw, GrowsWithTheProbability) {
  const std::vector<double> values = uniform_samples(3, 12);
  double previous = quantile(values, 0.0);
  for (int i = 1; i <= 100; ++i) {
    const double next = quantile(values, i / 100.0);
    ASSERT_GE(next, previous) << i << " %";
    previous = next;
  }
  EXPECT_GT(previous, quantile(values, 0.0));
}

TEST(QuantileLaw, ScalesWithTheValues) {
  const std::vector<double> values = uniform_samples(4, 12);
  std::vector<double> scaled;
  for (const double value : values) scaled.push_back(8.0 * value);  // a power of two: no rounding
  for (const double probability : {0.05, 0.5, 0.8})
    EXPECT_EQ(quantile(scaled, probability), 8.0 * quantile(values, probability));
}

}  // namespace
}  // namespace phytobench
