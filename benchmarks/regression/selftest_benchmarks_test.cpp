// SPDX-License-Identifier: MIT
#include "benchmarks/regression/selftest_benchmarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression/sampling.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

std::unique_ptr<WatchedKernel> prepared(const std::string& name) {
  for (const WatchedBenchmark& benchmark : selftest_benchmarks())
    if (benchmark.name == "selftest/" + name) return benchmark.prepare();
  return nullptr;
}

TEST(SelftestBenchmarks, AreFive) {
  EXPECT_EQ(selftest_benchmarks().size(), 5u);
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

TEST(SelftestBenchmarks, TheOneThatStopsIsRightAndIsRefusedAllTheSame) {
  for (const WatchedBenchmark& benchmark : selftest_benchmarks()) {
    if (benchmark.name != "selftest/stops-working") continue;
    const VerifiedBenchmark verified = verify_benchmark(benchmark);
    EXPECT_EQ(verified.objection, "");
    const auto steady = prepared("steady");
    steady->run();
    EXPECT_EQ(verified.answer, steady->answer());
    const CalibratedBenchmark calibrated = calibrate_benchmark(benchmark, 5e-3);
    ASSERT_GT(calibrated.iterations, 0u) << "nobody has looked at its answer";
    const auto sampled = sample_benchmarks(
        {benchmark},
        {.samples = 3, .benchmarks = {{benchmark.name, calibrated.iterations, verified.answer}}});
    EXPECT_THAT(sampled[0].objection, HasSubstr("takes no time"));
    EXPECT_TRUE(sampled[0].samples.empty());
    return;
  }
  FAIL() << "there is no such benchmark";
}

}  // namespace
}  // namespace phytobench
