// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/measured_result.hpp"

#include <gtest/gtest.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/simulated_sides.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

class MeasuredResult : public testing::Test {
 protected:
  SimulatedMachine machine_;
  ResultRequest request_{.names = {"a", "bb"}, .reference = "bb", .seed = 3, .processes = 7};

  StoredResult measure(const SimulatedBenchmark& a) {
    SimulatedSide side(machine_, 'A', {{"a", a}, {"bb", {.seconds = 2e-3}}});
    request_.side = &side;
    return measure_result(request_);
  }
};

TEST_F(MeasuredResult, HoldsEverySampleByProcess) {
  machine_.noise = 0.0;
  const StoredResult result = measure({});
  ASSERT_EQ(result.benchmarks.size(), 2u);
  const StoredBenchmark& a = result.benchmarks.front();
  EXPECT_EQ(a.answer, "answer");
  ASSERT_EQ(a.processes.size(), 7u);
  EXPECT_EQ(a.processes.front().size(), 5u);
  EXPECT_DOUBLE_EQ(a.processes.front().front(), 1e-3);
  EXPECT_DOUBLE_EQ(result.reference.value().seconds, 2e-3);
  EXPECT_NO_THROW(validate(result, "this test"));
}

TEST_F(MeasuredResult, GivesAWrongAnswerNoTime) {
  const StoredResult before = measure({.objection = "wrong"});
  EXPECT_EQ(before.benchmarks.front().objection, "wrong");
  EXPECT_TRUE(before.benchmarks.front().processes.empty());
  const StoredResult during = measure({.sampling_objection = "another answer"});
  EXPECT_EQ(during.benchmarks.front().objection, "another answer");
  EXPECT_TRUE(during.benchmarks.front().processes.empty());
  EXPECT_EQ(during.benchmarks.back().processes.size(), 7u);
}

TEST_F(MeasuredResult, KeepsNothingOfAProcessThatDiesAndMeasuresItAgain) {
  machine_.dead = {3};
  const StoredResult result = measure({});
  for (const StoredBenchmark& benchmark : result.benchmarks) {
    EXPECT_EQ(benchmark.objection, "");
    EXPECT_EQ(benchmark.processes.size(), 7u);
  }
  EXPECT_EQ(machine_.started.size(), 8u);
}

TEST_F(MeasuredResult, RefusesOnlyWhatProcessesDieOf) {
  for (const SimulatedBenchmark& deadly :
       {SimulatedBenchmark{.deaths = 1000}, SimulatedBenchmark{.calibration_deaths = 1000}}) {
    const StoredResult result = measure(deadly);
    EXPECT_EQ(result.benchmarks.front().objection, "its worker was killed; it happened 3 times");
    EXPECT_TRUE(result.benchmarks.front().processes.empty());
    EXPECT_EQ(result.benchmarks.back().objection, "");
    EXPECT_EQ(result.benchmarks.back().processes.size(), 7u);
  }
}

TEST_F(MeasuredResult, SaysWhatTakesNoTime) {
  EXPECT_EQ(measure({.iterations = 0}).benchmarks.front().objection, no_time_to_measure);
}

TEST_F(MeasuredResult, InterruptedKeepsNothing) {
  request_.is_interrupted = [&] { return machine_.started.size() >= 2; };
  EXPECT_THROW(measure({}), Interrupted);
}

}  // namespace
}  // namespace phytobench
