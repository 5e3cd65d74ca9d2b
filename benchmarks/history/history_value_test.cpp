// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_value.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(HistoryValue, QuantitiesComeBackFromTheirText) {
  for (const HistoryQuantity& quantity :
       {HistoryQuantity::counter("search_evaluations"), HistoryQuantity::instructions(),
        HistoryQuantity::ratio()})
    EXPECT_EQ(HistoryQuantity::named(quantity.text()), quantity);
  EXPECT_TRUE(HistoryQuantity::named("counter:x").is_counter());
  EXPECT_FALSE(HistoryQuantity::named("ratio").is_counter());
}

TEST(HistoryValue, SecondsAndOtherWordsAreNone) {
  for (const char* text : {"seconds", "time", "", "counter", "counter:", "counter:a b", "Ratio"})
    EXPECT_THROW(HistoryQuantity::named(text), InputError) << text;
}

TEST(HistoryValue, CountsKeepAllDigits) {
  const HistoryValue value =
      HistoryValue::counted("a", "", HistoryQuantity::instructions(), 9007199254740993u);
  EXPECT_EQ(value.count(), 9007199254740993);
  EXPECT_EQ(value.text(), "9007199254740993");
  EXPECT_THROW(HistoryValue::counted("a", "", HistoryQuantity::instructions(),
                                     std::numeric_limits<std::uint64_t>::max()),
               InputError);
}

TEST(HistoryValue, RatiosArePositiveNumbers) {
  EXPECT_EQ(HistoryValue::ratio("a", "", 1.25).text(), "1.25");
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(HistoryValue::ratio("a", "", wrong), InputError) << wrong;
  EXPECT_THROW(HistoryValue::counted("a", "", HistoryQuantity::ratio(), 1), ContractViolation);
}

}  // namespace
}  // namespace phytobench
