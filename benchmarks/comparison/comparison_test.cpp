// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

double log_ratio(std::vector<double> base, std::vector<double> other) {
  return BlockTimes{.base = std::move(base), .other = std::move(other)}.log_ratio();
}

TEST(BlockTimes, LogRatioIsTheMeanOfBothSides) {
  EXPECT_EQ(log_ratio({1.0, 1.0}, {1.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(log_ratio({1.0, 2.0}, {2.0, 4.0}), std::log(2.0));
  EXPECT_DOUBLE_EQ(log_ratio({1.0, 1.0}, {1.0, 4.0}), std::log(2.0));
}

TEST(BlockTimes, RefuseWhatIsNoBlock) {
  EXPECT_THROW(log_ratio({1.0}, {1.0, 1.0}), ContractViolation);
  EXPECT_THROW(log_ratio({1.0, 1.0}, {1.0, 1.0, 1.0}), ContractViolation);
  EXPECT_THROW(log_ratio({1.0, 0.0}, {1.0, 1.0}), ContractViolation);
  EXPECT_THROW(log_ratio({1.0, 1.0}, {1.0, -1.0}), ContractViolation);
  EXPECT_THROW(log_ratio({1.0, NAN}, {1.0, 1.0}), ContractViolation);
  EXPECT_THROW(log_ratio({1.0, 1.0}, {1.0, std::numeric_limits<double>::infinity()}),
               ContractViolation);
}

TEST(BlockTimesLaw, SwappedSidesNegateTheLogRatio) {
  EXPECT_EQ(log_ratio({1.3, 1.7}, {1.9, 1.1}), -log_ratio({1.9, 1.1}, {1.3, 1.7}));
}

// A processor that slows down as it warms up: every process takes longer than the last by as much.
TEST(BlockTimesLaw, EitherOrderCancelsAnEvenDrift) {
  const auto process_s = [](int place) { return 2.0 * std::exp(0.01 * place); };
  const std::vector<double> outer{process_s(0), process_s(3)}, inner{process_s(1), process_s(2)};
  EXPECT_NEAR(log_ratio(outer, inner), 0.0, 1e-15);
  EXPECT_NEAR(log_ratio(inner, outer), 0.0, 1e-15);
  // What alternates without turning back does not.
  EXPECT_NEAR(log_ratio({process_s(0), process_s(2)}, {process_s(1), process_s(3)}), 0.01, 1e-15);
}

TEST(SpeedVerdict, HasANameForEach) {
  std::set<std::string_view> names;
  for (int verdict = 0; verdict <= static_cast<int>(SpeedVerdict::wrong_answer); ++verdict)
    names.insert(name_of(static_cast<SpeedVerdict>(verdict)));
  EXPECT_EQ(names, (std::set<std::string_view>{"slower", "faster", "same", "inconclusive",
                                               "same binary", "nothing measured", "wrong answer"}));
  EXPECT_THROW(name_of(static_cast<SpeedVerdict>(99)), ContractViolation);
}

TEST(Comparison, BaseIsToBlameForWhatItLacksOrHasWrong) {
  ConcludedBenchmark benchmark;
  benchmark.verdict = SpeedVerdict::nothing_measured;
  benchmark.reason = std::string(only_new_has_it);
  EXPECT_TRUE(is_base_to_blame(benchmark));
  benchmark.reason = std::string(base_is_wrong) + "node 3 is too far";
  EXPECT_TRUE(is_base_to_blame(benchmark));
  benchmark.reason = "new does not have it";
  EXPECT_FALSE(is_base_to_blame(benchmark));
  benchmark.verdict = SpeedVerdict::wrong_answer;
  benchmark.reason = std::string(only_new_has_it);
  EXPECT_FALSE(is_base_to_blame(benchmark));
}

}  // namespace
}  // namespace phytobench
