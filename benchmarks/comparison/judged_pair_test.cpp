// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/judged_pair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/simulated_sides.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// The benchmark "a" of two sides.
MeasuredBenchmark judged(const SimulatedBenchmark& base, const SimulatedBenchmark& other) {
  SimulatedMachine machine;
  SimulatedSide first(machine, 'A', {{"a", base}});
  SimulatedSide second(machine, 'B', {{"a", other}});
  const JudgedPair pair = judge_pair(first, second, {"a"});
  EXPECT_EQ(pair.benchmarks.size(), 1u);
  EXPECT_EQ(pair.answers.contains("a"), pair.benchmarks.front().objection.empty());
  EXPECT_EQ(machine.started, "") << "nothing is timed";
  return pair.benchmarks.front();
}

TEST(JudgedPair, HasNothingAgainstTheSameRightAnswer) {
  EXPECT_EQ(judged({}, {}).objection, "");
  EXPECT_TRUE(judged({}, {}).is_same_work);
}

TEST(JudgedPair, NamesTheSideWithTheWrongAnswer) {
  const SimulatedBenchmark wrong{.answer = "other", .objection = "node 3 is too far"};
  EXPECT_EQ(judged({}, wrong).objection, "new: node 3 is too far");
  EXPECT_EQ(judged(wrong, {}).objection, "base is wrong: node 3 is too far");
  EXPECT_TRUE(judged({}, wrong).is_same_work);
  EXPECT_FALSE(judged(wrong, {}).is_same_work) << "whoever mends it is not at fault";
}

TEST(JudgedPair, ComparesOnlyTheSameWork) {
  const MeasuredBenchmark inputs = judged({}, {.inputs = "others"});
  EXPECT_FALSE(inputs.is_same_work);
  EXPECT_THAT(inputs.objection, HasSubstr("inputs"));
  const MeasuredBenchmark answers = judged({}, {.answer = "another right one"});
  EXPECT_FALSE(answers.is_same_work);
  EXPECT_THAT(answers.objection, HasSubstr("are right, but differ"));
}

TEST(JudgedPair, SaysWhichSideLacksABenchmark) {
  SimulatedMachine machine;
  SimulatedSide base(machine, 'A', {{"both", {}}, {"old", {}}});
  SimulatedSide other(machine, 'B', {{"both", {}}, {"new", {}}});
  const JudgedPair pair = judge_pair(base, other, {"new", "both", "old", "none"});
  ASSERT_EQ(pair.benchmarks.size(), 4u);
  EXPECT_EQ(pair.benchmarks[0].objection, "base does not have it");
  EXPECT_EQ(pair.benchmarks[1].objection, "");
  EXPECT_EQ(pair.benchmarks[2].objection, "new does not have it");
  EXPECT_EQ(pair.benchmarks[3].objection, "neither side has it");
  for (const std::size_t i : {0u, 2u, 3u}) EXPECT_FALSE(pair.benchmarks[i].is_same_work);
  EXPECT_EQ(pair.answers.size(), 1u);
}

}  // namespace
}  // namespace phytobench
