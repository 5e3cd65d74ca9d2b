// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_report.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/example_report.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(ComparisonReport, CountsWhatMattersFirst) {
  ComparisonReport report = example_report();
  EXPECT_EQ(counts_in_words(report),
            "1 wrong answer, 1 slower, 1 nothing measured, 1 inconclusive, 1 faster, 1 same of 6 "
            "benchmarks");
  std::string order;
  for (const ConcludedBenchmark* benchmark : by_weight(report)) order += benchmark->name + " ";
  EXPECT_EQ(order,
            "engine/wrong engine/slower engine/absent engine/noisy engine/faster engine/same ");
}

TEST(ComparisonReport, SaysThatNothingIsSlower) {
  ComparisonReport report;
  add_example(report, "a", SpeedVerdict::same, 1.0);
  EXPECT_EQ(counts_in_words(report), "0 slower, 1 same of 1 benchmark");
  EXPECT_THAT(advice(report), IsEmpty());
}

TEST(ComparisonReport, WeighsEveryVerdictOnce) {
  const auto& all = verdicts_by_weight();
  EXPECT_EQ(std::set<SpeedVerdict>(all.begin(), all.end()).size(), 7u);
  EXPECT_EQ(all.size(), 7u);
}

TEST(ComparisonReport, NamesInWhatTheSidesDifferBesidesTheirSources) {
  Measured measured;
  EXPECT_THAT(differences_of_sides(measured), IsEmpty());
  measured.base.compiler = "GNU 12";
  EXPECT_THAT(differences_of_sides(measured), IsEmpty()) << "the other is unknown";
  measured.other.compiler = "Clang 14";
  measured.base.flags = "-O2";
  measured.other.flags = "-O3";
  const auto sentences = differences_of_sides(measured);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_THAT(sentences[0], HasSubstr("compiler of base 'GNU 12', of new 'Clang 14'"));
  EXPECT_THAT(sentences[1], HasSubstr("flags of base '-O2', of new '-O3'"));
}

TEST(ComparisonReport, NamesSidesWithTheirCommits) {
  const Measured measured = example_report().timing.measured;
  EXPECT_EQ(side_in_words("base", measured.base), "base: HEAD~1 (revision, commit 1a2b3c4d5e6f)");
  EXPECT_EQ(side_in_words("new", measured.other),
            "new: build (build, commit f6e5d4c3b2a1 with changes)");
  EXPECT_EQ(side_in_words("new", {.given = "a.so", .kind = "plugin"}), "new: a.so (plugin)");
}

TEST(ComparisonReport, WithdrawsVerdictsOnSpeedButNoWrongAnswer) {
  ComparisonReport report = example_report();
  withdraw_verdicts(report.concluded);
  EXPECT_EQ(count_of(report, SpeedVerdict::inconclusive), 4u);
  EXPECT_EQ(count_of(report, SpeedVerdict::wrong_answer), 1u);
  EXPECT_EQ(count_of(report, SpeedVerdict::nothing_measured), 1u);
  EXPECT_EQ(report.concluded.front().reason, "interrupted after 8 blocks");
}

TEST(ComparisonReport, SaysWhichTrialFailedInPlaceOfCounts) {
  ComparisonReport report;
  report.failed_trials = {{"new", "b.so", "crashed", "SIGSEGV in create()"}};
  EXPECT_EQ(summary_in_words(report), "new failed its trial, so nothing was timed");
  EXPECT_EQ(in_words(report.failed_trials.front()),
            "new, b.so: crashed in its trial: SIGSEGV in create()");
  report.failed_trials.insert(report.failed_trials.begin(), {"base", "a.so", "leaks", "8 bytes"});
  EXPECT_EQ(summary_in_words(report), "base and new failed their trial, so nothing was timed");
  const ComparisonReport timed = example_report();
  EXPECT_EQ(summary_in_words(timed), counts_in_words(timed));
}

TEST(ComparisonReport, SaysThatWorkersDied) {
  ComparisonReport report;
  report.timing.dead_blocks = 1;
  ASSERT_EQ(advice(report).size(), 1u);
  EXPECT_EQ(advice(report).front(),
            "Workers died in 1 block, which was thrown away and measured again.");
}

TEST(ComparisonReport, AdvisesWhereAVerdictSaysLittle) {
  ComparisonReport report = example_report();
  report.timing.busy_blocks = 3;
  const auto sentences = advice(report);
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_THAT(sentences[0], HasSubstr("--budget"));
  EXPECT_THAT(sentences[1], HasSubstr("not measured"));
  EXPECT_THAT(sentences[2], HasSubstr("3 blocks were kept"));
}

}  // namespace
}  // namespace phytobench
