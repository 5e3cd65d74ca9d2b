// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/timed_block.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "benchmarks/comparison/simulated_sides.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

BlockPlan plan_of(int block) {
  return {.seed = 8, .block = block, .samples = 3, .benchmarks = {{"a", 10, "answer"}}};
}

class TimedBlockOf : public testing::Test {
 protected:
  SimulatedMachine machine_;
  SimulatedSide base_{machine_, 'A', {{"a", {}}}};
  SimulatedSide other_{machine_, 'B', {{"a", {}}}};

  TimedBlock run(const BlockPlan& plan) {
    return run_block(base_, other_, plan,
                     {.stolen_share = [&] { return machine_.take_stolen_share(); }});
  }
};

TEST_F(TimedBlockOf, FourProcessesRunsInItsOrder) {
  for (int block = 0; block < 20; ++block) {
    machine_.started.clear();
    const TimedBlock timed = run(plan_of(block));
    EXPECT_EQ(machine_.started, timed.order);
    EXPECT_EQ(timed.order, block_order(plan_of(block)));
    ASSERT_EQ(timed.processes.size(), 4u);
    EXPECT_EQ(timed.processes[0].front().samples.size(), 3u);
    EXPECT_FALSE(timed.was_busy);
  }
}

TEST(BlockOrder, IsDrawnFromTheSeedAndEitherIsAsOften) {
  int abba = 0;
  for (int block = 0; block < 1000; ++block) {
    const std::string order = block_order(plan_of(block));
    ASSERT_TRUE(order == "ABBA" || order == "BAAB");
    EXPECT_EQ(order, block_order(plan_of(block)));
    abba += order == "ABBA" ? 1 : 0;
  }
  EXPECT_NEAR(abba, 500, 80);  // five standard deviations
}

TEST(ProcessSeed, DiffersForEachProcessOfEachBlockOfEachPhase) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t phase = 0; phase < 2; ++phase)
    for (int block = 0; block < 50; ++block)
      for (int position = 0; position < 4; ++position) {
        BlockPlan plan = plan_of(block);
        plan.phase = phase;
        seeds.insert(process_seed(plan, position));
        EXPECT_LT(process_seed(plan, position), std::uint64_t{1} << 53);
      }
  EXPECT_EQ(seeds.size(), 400u);
  EXPECT_THROW(process_seed(plan_of(0), 4), ContractViolation);
}

TEST_F(TimedBlockOf, ABusyMachineSaysSo) {
  machine_.busy = {2};
  EXPECT_TRUE(run(plan_of(0)).was_busy);
  EXPECT_FALSE(run(plan_of(1)).was_busy);
  machine_.stolen = {11};  // the last of the third block
  EXPECT_TRUE(run(plan_of(2)).was_busy);
  EXPECT_FALSE(run(plan_of(3)).was_busy) << "what was stolen before is no fault of this block";
}

TEST_F(TimedBlockOf, ADeadWorkerEndsAndSaysWhichOneItWas) {
  machine_.dead = {2};
  const TimedBlock timed = run(plan_of(0));
  ASSERT_TRUE(timed.death);
  EXPECT_EQ(timed.death->reason, "its worker was killed");
  EXPECT_EQ(timed.processes.size(), 2u);
  EXPECT_EQ(machine_.started.size(), 3u);
  EXPECT_FALSE(run(plan_of(1)).death);
}

TEST(IsBusy, AllowsOneSwitchInTenMillisecondsAndFiveMore) {
  SampledBenchmark sampled{.name = "a", .samples = {{1, 0.09, 0.1}}, .involuntary_switches = 15};
  EXPECT_FALSE(is_busy({sampled}));
  sampled.involuntary_switches = 16;
  EXPECT_TRUE(is_busy({sampled}));
  EXPECT_FALSE(is_busy({sampled, {.name = "b", .samples = {{1, 0.1, 0.1}}}}));
}

TEST_F(TimedBlockOf, AnInterruptionEndsBeforeTheNextProcess) {
  int asked = 0;
  const BlockHooks hooks{.before_process = [&] {
    if (++asked > 2) throw std::runtime_error("stop");
  }};
  EXPECT_THROW(run_block(base_, other_, plan_of(0), hooks), std::runtime_error);
  EXPECT_EQ(machine_.started.size(), 2u);
}

TEST(SecondsPerIteration, IsTheMedianOfSamplesAndNothingWithoutTime) {
  SampledBenchmark sampled{.name = "a",
                           .samples = {{10, 0.1, 9.0}, {20, 0.4, 9.0}, {10, 0.9, 9.0}}};
  EXPECT_DOUBLE_EQ(seconds_per_iteration(sampled), 0.02);
  sampled.samples.push_back({10, 0.0, 1.0});
  EXPECT_EQ(seconds_per_iteration(sampled), 0.0);
  sampled.samples = {{0, 1.0, 1.0}};
  EXPECT_EQ(seconds_per_iteration(sampled), 0.0);
  EXPECT_EQ(seconds_per_iteration({.name = "a"}), 0.0);
}

}  // namespace
}  // namespace phytobench
