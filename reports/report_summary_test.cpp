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

TEST(ReportSummary, CallsAnErratumWrongAsPrintedAndTellsItsKind) {
  Claim claim;
  claim.erratum = "E1";
  JudgedRun judged;
  judged.papers.resize(1);
  judged.papers[0].errata = {{.id = "E1", .kind = ErratumKind::number}};
  judged.papers[0].judgements = {{.claim = &claim, .verdict = Verdict::reproduced_with_erratum}};
  EXPECT_THAT(report_summary(judged).text,
              HasSubstr("   1  wrong as printed, holds corrected\n         1  number\n"));
}

}  // namespace
}  // namespace phytobench
