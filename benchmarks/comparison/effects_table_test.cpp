// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/effects_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/example_report.hpp"

namespace phytobench {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Between the brackets.
std::string strip_of(const std::string& row) {
  const std::size_t open = row.find('['), close = row.find(']');
  EXPECT_NE(open, std::string::npos) << row;
  return row.substr(open + 1, close - open - 1);
}

std::string row_of(const ComparisonReport& report) {
  return effects_table(report).rows.front();
}

TEST(EffectsTable, HasARowForEachBenchmarkAlignedWithItsHeading) {
  const EffectsTable table = effects_table(example_report());
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_THAT(table.rows[0], StartsWith("wrong answer"));
  EXPECT_THAT(table.rows[1], StartsWith("slower"));
  EXPECT_THAT(table.rows[1], HasSubstr("1.100"));
  EXPECT_THAT(table.rows[1], HasSubstr("1.089 to 1.111"));
  EXPECT_THAT(table.rows[1], EndsWith("engine/slower\n"));
  for (const std::string& row : table.rows) {
    EXPECT_EQ(strip_of(row).size(), 25u);
    EXPECT_EQ(row.find("engine/"), table.heading.find("benchmark"));
  }
}

TEST(EffectsTable, ShowsTheSideOfOneOnWhichAnIntervalLies) {
  for (const double ratio : {0.8, 1.0, 1.25}) {
    ComparisonReport report;
    add_example(report, "a", SpeedVerdict::inconclusive, ratio);
    const std::string strip = strip_of(row_of(report));
    const std::size_t centre = 12, estimate = strip.find('o');
    ASSERT_NE(estimate, std::string::npos);
    EXPECT_EQ(estimate < centre, ratio < 1.0);
    EXPECT_EQ(estimate > centre, ratio > 1.0);
  }
}

TEST(EffectsTable, SaysWhereAnIntervalGoesBeyondTheStrip) {
  ComparisonReport report;
  add_example(report, "a", SpeedVerdict::slower, 9.0);
  EXPECT_THAT(strip_of(row_of(report)), EndsWith(">"));
  report = {};
  add_example(report, "a", SpeedVerdict::faster, 0.1);
  EXPECT_THAT(strip_of(row_of(report)), StartsWith("<"));
  report = {};
  add_example(report, "a", SpeedVerdict::slower, 1.5);
  EXPECT_THAT(strip_of(row_of(report)), Not(HasSubstr(">")));
}

TEST(EffectsTable, LeavesNoLineBreakInAName) {
  ComparisonReport report;
  add_example(report, "a\nb", SpeedVerdict::same, 1.0);
  EXPECT_THAT(row_of(report), EndsWith("a b\n"));
}

}  // namespace
}  // namespace phytobench
