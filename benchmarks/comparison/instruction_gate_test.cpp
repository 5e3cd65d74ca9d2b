// SPDX-License-Identifier: MIT
// Verdicts on counts that are made up. Counts of real programs: gate_breakage_test.cpp.
#include "benchmarks/comparison/instruction_gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;
using Verdict = InstructionVerdict;

const std::string base_commit = "0123456789ab";

InstructionCount count_of(std::uint64_t instructions) {
  return {.outcome = CountOutcome::counted,
          .reason = "",
          .totals = {.instructions = instructions, .misses = std::nullopt},
          .inputs = "i",
          .answer = "o"};
}

InstructionCount no_count(CountOutcome outcome) {
  return {.outcome = outcome, .reason = "because", .totals = {}, .inputs = "", .answer = ""};
}

CountedPair pair_of(std::uint64_t base, std::uint64_t other) {
  CountedPair pair{.benchmark = "overlap/sweep/equal"};
  pair.base = count_of(base);
  pair.other = count_of(other);
  return pair;
}

Verdict verdict_on(const CountedPair& pair) {
  return judge_instructions(pair, {}, base_commit).verdict;
}

TEST(InstructionGate, FailsAboveOnePercentAndNotesAboveAFifthOfIt) {
  EXPECT_EQ(verdict_on(pair_of(100000, 100000)), Verdict::same);
  EXPECT_EQ(verdict_on(pair_of(100000, 100199)), Verdict::same);
  EXPECT_EQ(verdict_on(pair_of(100000, 100201)), Verdict::slightly_more);
  EXPECT_EQ(verdict_on(pair_of(100000, 100999)), Verdict::slightly_more);
  EXPECT_EQ(verdict_on(pair_of(100000, 101001)), Verdict::more);
  EXPECT_EQ(verdict_on(pair_of(100000, 99801)), Verdict::same);
  EXPECT_EQ(verdict_on(pair_of(100000, 99700)), Verdict::fewer);
  EXPECT_TRUE(is_failure(Verdict::more));
  EXPECT_FALSE(is_failure(Verdict::slightly_more));
}

TEST(InstructionGate, ABenchmarkThatAlwaysMovedMayMove) {
  CountedPair pair = pair_of(100000, 103000);
  pair.earlier_changes = {0.02, -0.02, 0.03, -0.01, 0.02, 0.01, -0.03};
  EXPECT_EQ(verdict_on(pair), Verdict::more) << "seven changes are no history";
  pair.earlier_changes.push_back(0.02);
  EXPECT_EQ(verdict_on(pair), Verdict::slightly_more);
  pair.other = count_of(200000);
  EXPECT_EQ(verdict_on(pair), Verdict::more);
}

TEST(InstructionGate, TheLimitIsThreeQuartileRangesAboveTheThirdQuartile) {
  const std::vector<double> moved = {-0.01, 0.02, -0.03, 0.04, 0.05, -0.06, 0.07, 0.08, 0.09};
  EXPECT_DOUBLE_EQ(change_limit(moved), 0.07 + 3.0 * (0.07 - 0.03));
  const std::vector<double> never(20, 0.0);
  EXPECT_EQ(change_limit(never), 0.01);
  EXPECT_EQ(change_limit({}), 0.01);
}

TEST(InstructionGate, ACountOfAnotherAnswerThanWasVerifiedIsNone) {
  CountedPair pair = pair_of(1, 1);
  pair.verified_answer = "o";
  EXPECT_EQ(verdict_on(pair), Verdict::same);
  pair.verified_answer = "another";
  EXPECT_EQ(verdict_on(pair), Verdict::wrong_answer);
}

TEST(InstructionGate, WhatCannotBeCountedIsNoPass) {
  CountedPair pair = pair_of(1, 1);
  pair.other = no_count(CountOutcome::unsupported);
  const JudgedInstructions judged = judge_instructions(pair, {}, base_commit);
  EXPECT_EQ(judged.verdict, Verdict::unsupported);
  EXPECT_EQ(judged.reason, "because");
  EXPECT_EQ(exit_code_of({judged}), 3);
  pair = pair_of(1, 1);
  pair.base = no_count(CountOutcome::unsupported);
  EXPECT_EQ(verdict_on(pair), Verdict::unsupported);
}

TEST(InstructionGate, AWrongAnswerAndARunThatFailsStopAMerge) {
  CountedPair pair = pair_of(100, 100);
  pair.objection = "node 3 instead of 2";
  EXPECT_EQ(verdict_on(pair), Verdict::wrong_answer);
  pair = pair_of(100, 100);
  pair.other = no_count(CountOutcome::failed);
  EXPECT_EQ(verdict_on(pair), Verdict::failed);
  EXPECT_TRUE(is_failure(Verdict::wrong_answer));
  EXPECT_TRUE(is_failure(Verdict::failed));
}

TEST(InstructionGate, OtherWorkIsNotCompared) {
  CountedPair pair = pair_of(100, 900);
  pair.other.inputs = "j";
  EXPECT_EQ(verdict_on(pair), Verdict::other_work);
  EXPECT_FALSE(judge_instructions(pair, {}, base_commit).change);
  pair = pair_of(100, 900);
  pair.base.answer = "p";
  EXPECT_EQ(verdict_on(pair), Verdict::other_work);
  pair = pair_of(100, 900);
  pair.base = no_count(CountOutcome::failed);
  EXPECT_EQ(verdict_on(pair), Verdict::other_work);
}

TEST(InstructionGate, WhatOneSideLacksIsNewOrGone) {
  CountedPair pair = pair_of(100, 900);
  pair.is_in_base = false;
  EXPECT_EQ(verdict_on(pair), Verdict::appeared);
  pair.is_in_base = true;
  pair.is_in_new = false;
  EXPECT_EQ(verdict_on(pair), Verdict::gone);
}

TEST(InstructionGate, AnAcceptedIncreaseHoldsForItsSizeAndItsBase) {
  const std::vector<AcceptedIncrease> accepted = {
      {"overlap/*", 3.0, base_commit, "small"},
      {"overlap/*", 12.0, base_commit, "areas are summed in a fixed order"},
      {"tree/*", 99.0, base_commit, "another benchmark"}};
  const auto on = [&](std::uint64_t other, const std::string& base) {
    return judge_instructions(pair_of(1000, other), accepted, base);
  };
  EXPECT_EQ(on(1110, base_commit).verdict, Verdict::accepted);
  EXPECT_THAT(on(1110, base_commit).reason, HasSubstr("areas are summed"));
  EXPECT_FALSE(is_failure(Verdict::accepted));
  EXPECT_EQ(on(1130, base_commit).verdict, Verdict::more);
  EXPECT_THAT(on(1130, base_commit).reason, HasSubstr("more than the accepted 12 %"));
  EXPECT_EQ(on(1110, "fedcba987654").verdict, Verdict::more);
  EXPECT_EQ(on(1110, "").verdict, Verdict::more);
}

TEST(InstructionGate, TheExitCodeIsThatOfTheWorst) {
  const auto with = [](std::vector<Verdict> verdicts) {
    std::vector<JudgedInstructions> judged;
    for (const Verdict verdict : verdicts) judged.push_back({.verdict = verdict});
    return exit_code_of(judged);
  };
  EXPECT_EQ(with({Verdict::same, Verdict::same_binary, Verdict::appeared}), 0);
  EXPECT_EQ(with({Verdict::same, Verdict::unsupported, Verdict::more}), 1);
  EXPECT_EQ(with({Verdict::same, Verdict::unsupported}), 3);
  EXPECT_EQ(with({Verdict::appeared, Verdict::gone, Verdict::other_work}), 4);
  EXPECT_EQ(with({}), 4) << "a run that compared nothing is no pass";
}

TEST(InstructionGate, TheSameBinaryIsNotRun) {
  const CountedBuild build{"no/such/worker", "no/such/folder", {"a/b", "c/d"}};
  const std::vector<CountedPair> pairs =
      count_pairs({.base = build, .other = build, .is_same_binary = true});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(verdict_on(pairs[0]), Verdict::same_binary);
  EXPECT_EQ(pairs[1].benchmark, "c/d");
}

TEST(InstructionGate, WhatIsRefusedOrGoneIsNotRun) {
  const std::vector<CountedPair> pairs =
      count_pairs({.base = {"no/such/worker", "", {"gone/one"}},
                   .other = {"no/such/worker", "", {"wrong/one"}},
                   .objection_to = [](const std::string& name) { return name + " is wrong"; }});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(verdict_on(pairs[0]), Verdict::gone);
  EXPECT_EQ(verdict_on(pairs[1]), Verdict::wrong_answer);
}

}  // namespace
}  // namespace phytobench
