// SPDX-License-Identifier: MIT
// phytobench selftest as a user meets it. Never asserts on what a timing says.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;

using SelftestCommandSlow = CommandLine;

TEST_F(SelftestCommandSlow, RefusesBrokenBenchmarksAndCountsItsComparisons) {
  const Outcome outcome = run_line("selftest --repetitions 1 --json");
  EXPECT_THAT(outcome.code, AnyOf(0, 1)) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "phytobench/selftest-1");
  EXPECT_EQ(document["alike"]["compared"], 1);
  EXPECT_EQ(document["handicapped"]["compared"], 1);
  ASSERT_EQ(document["refusals"].size(), 3u);
  for (const json& refusal : document["refusals"])
    EXPECT_EQ(refusal["refused"], true) << refusal.dump();
  EXPECT_LE(document["false_alarms"]["low"], document["false_alarms"]["share"]);
  EXPECT_GE(document["noise_floor"], 0.0);
  EXPECT_GT(document["seconds"], 0.0);
}

TEST_F(SelftestCommandSlow, PrintsItsRates) {
  const Outcome outcome = run_line("selftest --repetitions 1");
  EXPECT_THAT(outcome.code, AnyOf(0, 1)) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("false alarms: "));
  EXPECT_THAT(outcome.out, HasSubstr("slowed down by 10 %"));
  EXPECT_THAT(outcome.out, HasSubstr("The instrument is "));
}

using SelftestCommand = CommandLine;

TEST_F(SelftestCommand, RefusesNumbersThatMakeNoSense) {
  expect_refused_line("selftest --repetitions 0", "--repetitions");
  expect_refused_line("selftest --seed -1", "--seed");
}

}  // namespace
}  // namespace phytobench
