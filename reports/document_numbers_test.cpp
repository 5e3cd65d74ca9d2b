// SPDX-License-Identifier: MIT
#include "reports/document_numbers.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(DocumentNumbers, GroupDigits) {
  EXPECT_EQ(with_thousands(5.0), "5");
  EXPECT_EQ(with_thousands(25298.0), "25,298");
  EXPECT_EQ(with_thousands(1234567.0), "1,234,567");
  EXPECT_EQ(with_thousands(-123456.0), "-123,456");
  EXPECT_EQ(with_thousands(-123.0), "-123");
}

TEST(DocumentNumbers, ShowTimesInTheUnitThatSuitsThem) {
  EXPECT_EQ(shown_seconds(0.0000123), "12.3 us");
  EXPECT_EQ(shown_seconds(0.0123), "12.3 ms");
  EXPECT_EQ(shown_seconds(12.34), "12.3 s");
}

TEST(DocumentNumbers, RoundTimesThatAReaderPlansWith) {
  EXPECT_EQ(rough_seconds(0.2), "under 1 s");
  EXPECT_EQ(rough_seconds(42.4), "42 s");
  EXPECT_EQ(rough_seconds(240.0), "4 min");
  EXPECT_EQ(rough_seconds(9000.0), "2.5 h");
}

TEST(DocumentNumbers, CountInWords) {
  EXPECT_EQ(counted(1, "claim"), "1 claim");
  EXPECT_EQ(counted(0, "claim"), "0 claims");
  EXPECT_EQ(counted(2, "is open", "are open"), "2 are open");
}

}  // namespace
}  // namespace phytobench
