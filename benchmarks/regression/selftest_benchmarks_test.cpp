// SPDX-License-Identifier: MIT
#include "benchmarks/regression/selftest_benchmarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;

std::unique_ptr<WatchedKernel> prepared(const std::string& name) {
  for (const WatchedBenchmark& benchmark : selftest_benchmarks())
    if (benchmark.name == "selftest/" + name) return benchmark.prepare();
  return nullptr;
}

TEST(SelftestBenchmarks, AreFour) {
  EXPECT_EQ(selftest_benchmarks().size(), 4u);
}

TEST(SelftestBenchmarks, TheSteadyOneIsRightHoweverOftenItRuns) {
  const auto steady = prepared("steady");
  EXPECT_NE(steady->objection(), "") << "it has not run";
  steady->run();
  const std::string answer = steady->answer();
  for (int run = 0; run < 10; ++run) {
    steady->run();
    EXPECT_EQ(steady->objection(), "");
    EXPECT_EQ(steady->answer(), answer);
    EXPECT_GT(steady->work().at("steps"), 0u);
  }
}

TEST(SelftestBenchmarks, TheWrongAnswerIsRefused) {
  const auto wrong = prepared("wrong-answer");
  wrong->run();
  EXPECT_THAT(wrong->objection(), HasSubstr("the judge has node"));
}

TEST(SelftestBenchmarks, TheOneThatMeasuresNothingHasNoWork) {
  const auto nothing = prepared("measures-nothing");
  nothing->run();
  EXPECT_EQ(nothing->objection(), "");
  EXPECT_TRUE(nothing->work().empty());
}

TEST(SelftestBenchmarks, TheForgetfulOneIsRightUntilItWasVerified) {
  const auto forgetful = prepared("forgets-work"), steady = prepared("steady");
  steady->run();
  for (int run = 0; run < 3; ++run) {
    forgetful->run();
    EXPECT_EQ(forgetful->objection(), "");
    EXPECT_EQ(forgetful->answer(), steady->answer());
  }
  forgetful->run();
  EXPECT_THAT(forgetful->objection(), HasSubstr("steps instead of"));
  EXPECT_NE(forgetful->answer(), steady->answer());
  EXPECT_GT(forgetful->work().at("steps"), 0u) << "it must still take time";
}

}  // namespace
}  // namespace phytobench
