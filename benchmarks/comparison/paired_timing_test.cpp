// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/paired_timing.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/simulated_sides.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// Two sides with benchmarks "a" and "b" unless a test says otherwise.
class PairedTiming : public testing::Test {
 protected:
  SimulatedMachine machine_;
  std::map<std::string, SimulatedBenchmark> base_ = {{"a", {}}, {"bb", {.seconds = 2e-3}}};
  std::map<std::string, SimulatedBenchmark> other_ = base_;
  TimingSettings settings_ = {.seed = 8, .least_blocks = 8, .most_blocks = 20, .samples = 3};
  std::function<bool()> is_interrupted_ = {};
  bool is_same_program_ = false;

  PairTiming measure() {
    SimulatedSide base(machine_, 'A', base_);
    SimulatedSide other(machine_, 'B', other_);
    PairRequest request = simulated_pair(machine_, base, other, {"a", "bb"});
    request.settings = settings_;
    request.is_interrupted = is_interrupted_;
    request.is_same_program = is_same_program_;
    return measure_pair(request);
  }
};

TEST_F(PairedTiming, FindsTheRatioInEveryBlockWithoutNoise) {
  machine_.noise = 0.0;
  other_["a"].seconds = 1.1e-3;
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.control.size(), 8u);
  EXPECT_EQ(a.blocks.size(), 8u);
  for (const BlockTimes& block : a.control) EXPECT_NEAR(block.log_ratio(), 0.0, 1e-12);
  for (const BlockTimes& block : a.blocks) EXPECT_NEAR(block.log_ratio(), std::log(1.1), 1e-12);
  for (const BlockTimes& block : timing.measured.benchmarks.back().blocks)
    EXPECT_NEAR(block.log_ratio(), 0.0, 1e-12);
}

TEST_F(PairedTiming, ASteadyDriftCancelsWithinEachBlock) {
  machine_.noise = 0.0;
  machine_.drift = 0.01;  // each process is slower than the one before
  const PairTiming timing = measure();
  for (const BlockTimes& block : timing.measured.benchmarks.front().blocks)
    EXPECT_NEAR(block.log_ratio(), 0.0, 1e-12);
}

TEST_F(PairedTiming, BeginsWithTheControlThroughTheSamePath) {
  machine_.noise = 0.0;
  const PairTiming timing = measure();
  EXPECT_EQ(machine_.started.substr(0, 32), std::string(32, 'A'));
  std::string orders;
  for (const BlockTimes& block : timing.measured.benchmarks.front().blocks) orders += block.order;
  EXPECT_EQ(machine_.started.substr(32), orders);
  for (std::size_t i = 0; i < machine_.plans.size(); ++i) {
    EXPECT_EQ(machine_.plans[i].samples, 3);
    EXPECT_EQ(machine_.plans[i].benchmarks.front().iterations, 10u);
    EXPECT_EQ(machine_.plans[i].benchmarks.front().answer, "answer");
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(machine_.plans[i].seed, machine_.plans[j].seed);
  }
}

TEST_F(PairedTiming, KeepsEverySampleOfEveryBlock) {
  const PairTiming timing = measure();
  std::size_t blocks = 0;
  for (const MeasuredBenchmark& benchmark : timing.measured.benchmarks)
    blocks += benchmark.control.size() + benchmark.blocks.size();
  EXPECT_EQ(timing.samples.size(), 4 * blocks);
  for (const ProcessSamples& process : timing.samples)
    EXPECT_EQ(process.sampled.samples.size(), 3u);
}

TEST_F(PairedTiming, StopsABenchmarkByTheWidthOfItsIntervalOnly) {
  settings_.most_blocks = 60;
  machine_.noise = 0.0;
  base_["a"].seconds = other_["a"].seconds = 1e-3;
  EXPECT_EQ(measure().measured.benchmarks.front().blocks.size(), 8u);

  machine_.noise = 0.5;  // far too wide at any number of blocks
  EXPECT_EQ(measure().measured.benchmarks.front().blocks.size(), 60u);

  machine_.noise = 0.04;
  const std::size_t equal = measure().measured.benchmarks.front().blocks.size();
  EXPECT_GT(equal, 8u);
  EXPECT_LT(equal, 60u);
  machine_.started.clear();
  const std::size_t again = measure().measured.benchmarks.front().blocks.size();
  machine_.started.clear();
  other_["a"].seconds *= 3.0;  // a loss nobody could overlook makes no difference
  EXPECT_EQ(measure().measured.benchmarks.front().blocks.size(), again);
}

TEST_F(PairedTiming, NoLongerRunsWhatIsDone) {
  settings_.most_blocks = 60;
  settings_.tolerance = 0.02;
  machine_.noise = 0.03;
  const PairTiming timing = measure();
  const std::size_t a = timing.measured.benchmarks.front().blocks.size();
  const std::size_t b = timing.measured.benchmarks.back().blocks.size();
  ASSERT_NE(a, b);
  EXPECT_EQ(machine_.plans.back().benchmarks.size(), 1u);
  EXPECT_EQ(machine_.plans.back().benchmarks.front().name, a > b ? "a" : "bb");
}

TEST_F(PairedTiming, EndsWithItsBudgetOfWhichTheControlTakesHalf) {
  machine_.noise = 0.5;
  settings_.most_blocks = 60;
  settings_.budget_s = 10.0;  // a block takes 4 x 3 x 10 x (1 + 2) ms = 0.36 s
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_NEAR(static_cast<double>(a.control.size()), 5.0 / 0.36, 3.0);
  EXPECT_NEAR(static_cast<double>(a.blocks.size()), 5.0 / 0.36, 3.0);
  EXPECT_LT(timing.seconds, 11.0);
  EXPECT_GT(timing.seconds, 7.0);
}

TEST_F(PairedTiming, HasOneBlockOfEachWhateverTheBudget) {
  settings_.budget_s = 1e-9;
  const PairTiming timing = measure();
  EXPECT_EQ(timing.measured.benchmarks.front().control.size(), 1u);
  EXPECT_EQ(timing.measured.benchmarks.front().blocks.size(), 1u);
}

TEST_F(PairedTiming, RedoesABusyBlockWithBothSidesAndCountsIt) {
  machine_.noise = 0.0;
  machine_.busy = {5};     // in the second block
  machine_.stolen = {14};  // in the third, which the redoing has moved to processes 12 to 15
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_EQ(timing.redone_blocks, 2);
  EXPECT_EQ(timing.busy_blocks, 0);
  EXPECT_EQ(a.control.size(), 8u);
  EXPECT_EQ(a.control[1].redone, 1);
  EXPECT_EQ(a.control[2].redone, 1);
  EXPECT_EQ(a.control[3].redone, 0);
  EXPECT_EQ(machine_.started.size(), 4u * (8 + 8 + 2));
  EXPECT_EQ(timing.samples.size(), 4u * (8 + 8) * 2) << "what was thrown away is not kept";
}

TEST_F(PairedTiming, OnAMachineThatIsAlwaysBusyRedoesNoMoreThanItKeeps) {
  machine_.noise = 0.0;
  for (int process = 0; process < 1000; ++process) machine_.busy.insert(process);
  const PairTiming timing = measure();
  EXPECT_EQ(timing.measured.benchmarks.front().blocks.size(), 8u);
  EXPECT_EQ(timing.busy_blocks, 16);
  EXPECT_EQ(timing.redone_blocks, 16);
}

TEST_F(PairedTiming, GivesAWrongAnswerNoTime) {
  other_["a"].objection = "node 3 is too far";
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_EQ(a.objection, "new: node 3 is too far");
  EXPECT_TRUE(a.control.empty() && a.blocks.empty());
  for (const SamplePlan& plan : machine_.plans) {
    ASSERT_EQ(plan.benchmarks.size(), 1u);
    EXPECT_EQ(plan.benchmarks.front().name, "bb");
  }
}

TEST_F(PairedTiming, TakesAwayTheTimesOfAnAnswerThatGoesWrongLater) {
  machine_.noise = 0.0;
  other_["a"].sampling_objection = "another answer than before";
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_EQ(a.objection, "new: another answer than before");
  EXPECT_TRUE(a.control.empty() && a.blocks.empty());
  for (const ProcessSamples& process : timing.samples) EXPECT_EQ(process.benchmark, "bb");
  EXPECT_EQ(timing.measured.benchmarks.back().blocks.size(), 8u);
}

TEST_F(PairedTiming, ThrowsAwayABlockInWhichAWorkerDiesAndMeasuresItWholeAgain) {
  machine_.noise = 0.0;
  machine_.dead = {5, 40};  // the second of the second block; in the comparison
  const PairTiming timing = measure();
  EXPECT_EQ(timing.dead_blocks, 2);
  EXPECT_EQ(timing.redone_blocks, 0);
  for (const MeasuredBenchmark& benchmark : timing.measured.benchmarks) {
    EXPECT_EQ(benchmark.objection, "");
    EXPECT_EQ(benchmark.control.size(), 8u);
    ASSERT_EQ(benchmark.blocks.size(), 8u);
    for (int block = 0; block < 8; ++block)
      EXPECT_EQ(benchmark.blocks[static_cast<std::size_t>(block)].block, block);
  }
  EXPECT_EQ(timing.samples.size(), 4u * (8 + 8) * 2) << "nothing of the broken blocks is kept";
  EXPECT_GT(machine_.started.size(), 4u * (8 + 8) + 2);
}

TEST_F(PairedTiming, RefusesOnlyTheBenchmarkThatWorkersDieOfAndNamesTheSide) {
  machine_.noise = 0.0;
  other_["a"].deaths = 1000;
  const PairTiming timing = measure();
  const MeasuredBenchmark& a = timing.measured.benchmarks.front();
  EXPECT_EQ(a.objection, "new: its worker was killed; it happened 3 times");
  EXPECT_TRUE(a.is_same_work) << "base could do it";
  EXPECT_TRUE(a.control.empty() && a.blocks.empty());
  for (const ProcessSamples& process : timing.samples) EXPECT_EQ(process.benchmark, "bb");
  EXPECT_EQ(timing.measured.benchmarks.back().objection, "");
  EXPECT_EQ(timing.measured.benchmarks.back().blocks.size(), 8u);
  EXPECT_EQ(conclude(timing.measured).front().verdict, SpeedVerdict::wrong_answer);
  EXPECT_EQ(timing.dead_blocks, 6) << "three of both benchmarks, three of one";
}

TEST_F(PairedTiming, EveryBlockOfWhatSurvivesHasTwoProcessesOfEachSide) {
  machine_.noise = 0.0;
  other_["a"].deaths = 4;  // more than are tried again together, fewer than by itself
  const PairTiming timing = measure();
  std::map<std::pair<std::string, int>, std::string> sides;
  for (const ProcessSamples& process : timing.samples)
    if (!process.is_control)
      sides[{process.benchmark, process.block}] += process.is_second ? 'B' : 'A';
  EXPECT_EQ(sides.size(), 16u);
  for (const MeasuredBenchmark& benchmark : timing.measured.benchmarks) {
    EXPECT_EQ(benchmark.objection, "");
    for (const BlockTimes& block : benchmark.blocks)
      EXPECT_EQ((sides[{benchmark.name, block.block}]), block.order);
  }
}

TEST_F(PairedTiming, ABaseThatDiesIsNoFaultOfNew) {
  machine_.noise = 0.0;
  base_["a"].deaths = 1000;
  const PairTiming timing = measure();
  const std::vector<ConcludedBenchmark> concluded = conclude(timing.measured);
  EXPECT_EQ(concluded.front().reason, "base is wrong: its worker was killed; it happened 3 times");
  EXPECT_EQ(concluded.front().verdict, SpeedVerdict::nothing_measured);
  EXPECT_TRUE(is_base_to_blame(concluded.front()));
  EXPECT_EQ(timing.measured.benchmarks.back().blocks.size(), 8u);
}

TEST_F(PairedTiming, SurvivesAWorkerThatDiesWhileSamplesAreSized) {
  machine_.noise = 0.0;
  base_["a"].calibration_deaths = 1000;
  const PairTiming timing = measure();
  EXPECT_EQ(timing.measured.benchmarks.front().objection,
            "base is wrong: its worker was killed; it happened 3 times");
  EXPECT_EQ(timing.measured.benchmarks.back().blocks.size(), 8u);
  base_["a"].calibration_deaths = 1;
  machine_.started.clear();
  EXPECT_EQ(measure().measured.benchmarks.front().objection, "");
}

TEST_F(PairedTiming, KeepsWhatTakesNoTimeAsSuch) {
  base_["a"].iterations = 0;
  const PairTiming timing = measure();
  EXPECT_EQ(timing.measured.benchmarks.front().objection, no_time_to_measure);
  EXPECT_FALSE(timing.measured.benchmarks.front().is_same_work) << "no wrong answer, either";
  EXPECT_FALSE(timing.measured.benchmarks.back().blocks.empty());
}

TEST_F(PairedTiming, TimesNothingOfTheSameProgramButJudgesIt) {
  is_same_program_ = true;
  base_["a"].objection = other_["a"].objection = "wrong";
  const PairTiming timing = measure();
  EXPECT_TRUE(timing.measured.is_same_program);
  EXPECT_EQ(machine_.started, "");
  EXPECT_EQ(timing.measured.benchmarks.front().objection, "new: wrong");
}

TEST_F(PairedTiming, InterruptedKeepsWholeBlocks) {
  machine_.noise = 0.5;
  is_interrupted_ = [&] { return machine_.started.size() >= 90; };  // in the third after control
  const PairTiming timing = measure();
  EXPECT_TRUE(timing.was_interrupted);
  EXPECT_EQ(timing.measured.benchmarks.front().control.size(), 20u);
  EXPECT_EQ(timing.measured.benchmarks.front().blocks.size(), 2u);
}

TEST_F(PairedTiming, InterruptedBeforeTheFirstBlockThrows) {
  is_interrupted_ = [] { return true; };
  EXPECT_THROW(measure(), Interrupted);
}

TEST_F(PairedTiming, RefusesSettingsThatMakeNoSense) {
  settings_.least_blocks = 5;
  EXPECT_THROW(measure(), ContractViolation);
  settings_ = {.least_blocks = 9, .most_blocks = 8};
  EXPECT_THROW(measure(), ContractViolation);
  settings_ = {.tolerance = 0.0};
  EXPECT_THROW(measure(), ContractViolation);
}

}  // namespace
}  // namespace phytobench
