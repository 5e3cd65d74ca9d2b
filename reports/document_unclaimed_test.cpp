// SPDX-License-Identifier: MIT
#include "reports/document_unclaimed.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

JudgedRun judged_run_of(const std::vector<std::string>& measurements) {
  JudgedRun judged;
  for (const std::string& name : measurements)
    judged.run.records.push_back({.experiment = "b/x", .measurement = "b/x/" + name, .value = 1.0});
  return judged;
}

TEST(Unclaimed, AreOneGroupWhereNamesDifferInNumbersAlone) {
  const auto document = unclaimed_document(
      judged_run_of({"step-0/plants", "step-20/plants", "step-20/mean", "end/plants", "total"}),
      false);
  ASSERT_EQ(document.size(), 1u);
  EXPECT_EQ(document[0]["experiment"], "b/x");
  EXPECT_EQ(document[0]["count"], 5);
  ASSERT_EQ(document[0]["groups"].size(), 3u);
  EXPECT_EQ(document[0]["groups"][0]["group"], "(directly)");
  EXPECT_EQ(document[0]["groups"][1]["group"], "end");
  EXPECT_EQ(document[0]["groups"][2]["group"], "step-*");
  EXPECT_EQ(document[0]["groups"][2]["count"], 3);
}

TEST(Unclaimed, LeaveOutCostsAndOnRequestTimes) {
  JudgedRun judged;
  for (const char* name : {"b/x/a/seconds", "b/x/cost/seconds"})
    judged.run.timings.push_back({.experiment = "b/x", .measurement = name, .value = 1.0});
  EXPECT_EQ(unclaimed_document(judged, false)[0]["count"], 1);
  EXPECT_TRUE(unclaimed_document(judged, true).empty());
}

}  // namespace
}  // namespace phytobench
