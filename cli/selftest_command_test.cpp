// SPDX-License-Identifier: MIT
// phytobench selftest as a user meets it. Never asserts on what a timing says.
#include <cstdlib>

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
  EXPECT_EQ(document["usual"]["compared"], 1);
  EXPECT_THAT(document["usual"]["benchmarks"].dump(), HasSubstr("nearest-node/node_driven/dn"));
  EXPECT_GT(document["usual"]["benchmarks"].size(), 1u);
  ASSERT_EQ(document["refusals"].size(), 4u);
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
  EXPECT_THAT(outcome.out, HasSubstr("The same as compare does it, with "));
  EXPECT_THAT(outcome.out, HasSubstr("slowed down by 10 %"));
  EXPECT_THAT(outcome.out, HasSubstr("The instrument is "));
}

using SelftestCommand = CommandLine;

TEST_F(SelftestCommand, RefusesNumbersThatMakeNoSense) {
  expect_refused_line("selftest --repetitions 0", "--repetitions");
  expect_refused_line("selftest --seed -1", "--seed");
}

TEST_F(SelftestCommand, DoesNotMeasureForMinutesWhatItCannotPrint) {
  const std::string line = std::string("'") + PHYTOBENCH_PROGRAM + "' selftest >&- 2>'" +
                           (folder() / "err").string() + "'";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(read("err"), HasSubstr("standard output is not open for writing"));
}

}  // namespace
}  // namespace phytobench
