// SPDX-License-Identifier: MIT
#include "reports/report_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(ReportSummary, NamesTheExperimentWhoseRecordsBreakOff) {
  JudgedRun judged;
  EXPECT_THAT(report_summary(judged).text, Not(HasSubstr("left out")));
  judged.run.unfinished = "p/two";
  EXPECT_THAT(report_summary(judged).text,
              EndsWith("p/two was left out: its records break off; go on with --resume\n"));
  EXPECT_EQ(report_summary(judged).unexpected, 0u);
}

}  // namespace
}  // namespace phytobench
