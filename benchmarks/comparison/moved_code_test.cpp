// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/moved_code.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

ConcludedBenchmark concluded(const std::string& name, SpeedVerdict verdict) {
  ConcludedBenchmark benchmark;
  benchmark.name = name;
  benchmark.verdict = verdict;
  benchmark.reason = "+20 %";
  return benchmark;
}

CountedPair counted(const std::string& name, std::uint64_t base, std::uint64_t other) {
  CountedPair pair;
  pair.benchmark = name;
  pair.base.outcome = pair.other.outcome = CountOutcome::counted;
  pair.base.totals.instructions = base;
  pair.other.totals.instructions = other;
  return pair;
}

TEST(MovedCode, OnlyChangesAreWorthCounting) {
  EXPECT_THAT(
      names_to_count({concluded("a", SpeedVerdict::slower), concluded("b", SpeedVerdict::same),
                      concluded("c", SpeedVerdict::faster),
                      concluded("d", SpeedVerdict::wrong_answer)}),
      ElementsAre("a", "c"));
}

TEST(MovedCode, ThatExecutesTheSameIsNoChange) {
  std::vector<ConcludedBenchmark> all = {concluded("a", SpeedVerdict::slower),
                                         concluded("b", SpeedVerdict::faster)};
  consider_instructions(all, {counted("a", 1000000, 1000000), counted("b", 1000000, 1001800)});
  for (const ConcludedBenchmark& benchmark : all) {
    EXPECT_EQ(benchmark.verdict, SpeedVerdict::inconclusive);
    EXPECT_THAT(benchmark.reason, HasSubstr("the same instructions"));
    EXPECT_THAT(benchmark.reason, HasSubstr("+20 %")) << "what was measured is still told";
  }
}

TEST(MovedCode, MoreWorkStaysSlower) {
  std::vector<ConcludedBenchmark> all = {concluded("a", SpeedVerdict::slower)};
  consider_instructions(all, {counted("a", 1000000, 1003000)});
  EXPECT_EQ(all[0].verdict, SpeedVerdict::slower);
  EXPECT_THAT(all[0].reason, HasSubstr("instructions +0.30 %"));
}

TEST(MovedCode, WhatWasNotCountedStaysAsItIs) {
  std::vector<ConcludedBenchmark> all = {concluded("a", SpeedVerdict::slower),
                                         concluded("b", SpeedVerdict::slower),
                                         concluded("c", SpeedVerdict::wrong_answer)};
  CountedPair unsupported = counted("b", 0, 0);
  unsupported.base.outcome = CountOutcome::unsupported;
  consider_instructions(all, {unsupported, counted("c", 5, 5)});
  EXPECT_EQ(all[0].verdict, SpeedVerdict::slower);
  EXPECT_EQ(all[1].verdict, SpeedVerdict::slower);
  EXPECT_EQ(all[2].verdict, SpeedVerdict::wrong_answer);
}

}  // namespace
}  // namespace phytobench
