// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/unpaired_verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

const ResultMachine two_processors{.processor = "Model 1", .logical_processors = 2};

/// Times around `seconds`, evenly spread over a share `noise` of it.
std::vector<double> times(double seconds, double noise, std::size_t count, std::uint64_t stream) {
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(seconds * (1.0 + noise * (2.0 * random_unit(1, stream, i) - 1.0)));
  return result;
}

StoredBenchmark benchmark_of(const std::string& name, std::vector<double> samples) {
  return {.name = name, .processes = {std::move(samples)}};
}

StoredResult result_of(std::vector<StoredBenchmark> benchmarks) {
  return {.origin = {.given = "x.json", .kind = "result"},
          .machine = two_processors,
          .benchmarks = std::move(benchmarks)};
}

StoredResult result_of(std::vector<double> samples) {
  return result_of({benchmark_of("a", std::move(samples))});
}

ConcludedBenchmark verdict_on(const StoredResult& base, const StoredResult& other) {
  const std::vector<ConcludedBenchmark> all = conclude_stored(base, other);
  EXPECT_EQ(all.size(), 1u);
  return all.at(0);
}

TEST(UnpairedVerdict, LossOfAFifthIsFoundUnderOnePerCentOfNoise) {
  for (std::uint64_t stream = 0; stream < 20; ++stream) {
    const StoredResult base = result_of(times(1e-3, 0.01, 15, 2 * stream));
    const StoredResult other = result_of(times(1.2e-3, 0.01, 15, 2 * stream + 1));
    const ConcludedBenchmark slower = verdict_on(base, other);
    EXPECT_EQ(slower.verdict, SpeedVerdict::slower) << slower.reason;
    EXPECT_NEAR(slower.ratio->value, 1.2, 0.02);
    EXPECT_LT(slower.p, 0.001);
    EXPECT_EQ(slower.blocks, 15u);
    EXPECT_EQ(verdict_on(other, base).verdict, SpeedVerdict::faster);
  }
}

TEST(UnpairedVerdict, EqualBuildsAreSameOrUndecidedButNeverChanged) {
  int same = 0;
  for (std::uint64_t stream = 0; stream < 40; ++stream) {
    const SpeedVerdict verdict = verdict_on(result_of(times(1e-3, 0.04, 15, 100 + 2 * stream)),
                                            result_of(times(1e-3, 0.04, 15, 101 + 2 * stream)))
                                     .verdict;
    EXPECT_TRUE(verdict == SpeedVerdict::same || verdict == SpeedVerdict::inconclusive);
    same += verdict == SpeedVerdict::same ? 1 : 0;
  }
  EXPECT_GT(same, 30);
}

TEST(UnpairedVerdict, ChangeWithinTheNoiseOrTheToleranceIsNone) {
  const ConcludedBenchmark noisy =
      verdict_on(result_of(times(1e-3, 0.5, 15, 1)), result_of(times(1.2e-3, 0.5, 15, 2)));
  EXPECT_EQ(noisy.verdict, SpeedVerdict::inconclusive);
  EXPECT_GT(noisy.noise_floor, 0.1);
  // Surely slower, but by less than stored times can tell.
  EXPECT_EQ(
      verdict_on(result_of(times(1e-3, 0.001, 15, 1)), result_of(times(1.05e-3, 0.001, 15, 2)))
          .verdict,
      SpeedVerdict::same);
  // The interval reaches over the tolerance.
  EXPECT_EQ(verdict_on(result_of(times(1e-3, 0.04, 15, 1)), result_of(times(1.08e-3, 0.04, 15, 2)))
                .verdict,
            SpeedVerdict::inconclusive);
}

TEST(UnpairedVerdictLaw, UnitOfTimeDoesNotMatter) {
  const std::vector<double> before = times(1e-3, 0.05, 15, 1), after = times(1.3e-3, 0.05, 15, 2);
  const ConcludedBenchmark first = verdict_on(result_of(before), result_of(after));
  for (const double factor : {1e-6, 0.3, 7.0, 1e9}) {
    std::vector<double> scaled_before = before, scaled_after = after;
    for (double& seconds : scaled_before) seconds *= factor;
    for (double& seconds : scaled_after) seconds *= factor;
    const ConcludedBenchmark scaled = verdict_on(result_of(scaled_before), result_of(scaled_after));
    EXPECT_EQ(scaled.verdict, first.verdict);
    EXPECT_DOUBLE_EQ(scaled.p, first.p);
    EXPECT_NEAR(scaled.ratio->low, first.ratio->low, 1e-12);
    EXPECT_NEAR(scaled.noise_floor, first.noise_floor, 1e-12);
  }
}

TEST(UnpairedVerdictLaw, OtherBenchmarksChangeNothingButTheAdjustedP) {
  const StoredBenchmark a = benchmark_of("a", times(1e-3, 0.05, 15, 1));
  const StoredBenchmark b = benchmark_of("b", times(1e-3, 0.05, 15, 3));
  const ConcludedBenchmark alone = verdict_on(result_of({a}), result_of({a}));
  const ConcludedBenchmark beside = conclude_stored(result_of({b, a}), result_of({a, b})).at(1);
  EXPECT_EQ(beside.name, "a");
  EXPECT_EQ(alone.ratio->low, beside.ratio->low);
  EXPECT_EQ(alone.noise_floor, beside.noise_floor);
  EXPECT_EQ(alone.verdict, SpeedVerdict::same);
}

TEST(UnpairedVerdict, FewRepetitionsGetAdviceInsteadOfAVerdict) {
  const ConcludedBenchmark few =
      verdict_on(result_of(times(1e-3, 0.001, 8, 1)), result_of(times(2e-3, 0.001, 15, 2)));
  EXPECT_EQ(few.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(few.reason, HasSubstr("--benchmark_repetitions=9"));
  EXPECT_FALSE(few.ratio.has_value());
  EXPECT_EQ(
      verdict_on(result_of(times(1e-3, 0.001, 9, 1)), result_of(times(2e-3, 0.001, 9, 2))).verdict,
      SpeedVerdict::slower);
}

TEST(UnpairedVerdict, SamplesOfFewProcessesAreFewRepetitions) {
  StoredBenchmark before{.name = "a", .is_by_process = true}, after = before;
  for (std::uint64_t process = 0; process < 8; ++process) {
    before.processes.push_back(times(1e-3, 0.01, 20, process));
    after.processes.push_back(times(2e-3, 0.01, 20, 50 + process));
  }
  const ConcludedBenchmark few = verdict_on(result_of({before}), result_of({after}));
  EXPECT_EQ(few.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(few.reason, HasSubstr("8 and 8 processes"));
}

TEST(UnpairedVerdict, OtherMachinesGetNoVerdict) {
  const StoredResult base = result_of(times(1e-3, 0.01, 15, 1));
  const auto reason_with = [&](auto change) {
    StoredResult other = result_of(times(2e-3, 0.01, 15, 2));
    change(other.machine);
    const ConcludedBenchmark verdict = verdict_on(base, other);
    EXPECT_EQ(verdict.verdict, SpeedVerdict::inconclusive);
    EXPECT_FALSE(verdict.ratio.has_value());
    return verdict.reason;
  };
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.processor = "Model 2"; }), HasSubstr("Model 2"));
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.logical_processors = 4; }),
              HasSubstr("2 and 4"));
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.logical_processors = 0; }),
              HasSubstr("does not say"));
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.library_build = "debug"; }), HasSubstr("debug"));
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.caches = "L1"; }), HasSubstr("caches"));
  EXPECT_THAT(reason_with([](ResultMachine& m) { m.mhz = 3000; }), HasSubstr("3000 MHz"));
  EXPECT_EQ(difference_of_machines(two_processors, two_processors), "");
}

TEST(UnpairedVerdict, WhatHasNoTimesIsNoPass) {
  const StoredBenchmark good = benchmark_of("a", times(1e-3, 0.01, 15, 1));
  const auto verdict_with = [&](StoredBenchmark before, StoredBenchmark after) {
    return verdict_on(result_of({std::move(before)}), result_of({std::move(after)})).verdict;
  };
  StoredBenchmark wrong{.name = "a", .objection = "node 3 instead of 2"};
  EXPECT_EQ(verdict_with(good, wrong), SpeedVerdict::wrong_answer);
  EXPECT_EQ(verdict_on(result_of({good}), result_of({wrong})).reason, "new: node 3 instead of 2");
  EXPECT_EQ(verdict_with(wrong, good), SpeedVerdict::nothing_measured);
  const StoredBenchmark idle{.name = "a", .objection = std::string(no_time_to_measure)};
  EXPECT_EQ(verdict_with(good, idle), SpeedVerdict::nothing_measured);
  EXPECT_EQ(verdict_with(good, {.name = "a"}), SpeedVerdict::nothing_measured);
  EXPECT_EQ(verdict_with(good, {.name = "a", .is_aggregate_only = true}),
            SpeedVerdict::nothing_measured);
  StoredBenchmark one = good, two = good;
  one.inputs = "i";
  two.inputs = "j";
  EXPECT_EQ(verdict_with(one, two), SpeedVerdict::nothing_measured);
  two.inputs = "i";
  one.answer = "x";
  two.answer = "y";
  EXPECT_EQ(verdict_with(one, two), SpeedVerdict::wrong_answer);
}

TEST(UnpairedVerdict, BenchmarksOfOneSideAreListedAndNothingInCommonIsRefused) {
  const std::vector<double> samples = times(1e-3, 0.01, 15, 1);
  const auto all =
      conclude_stored(result_of({benchmark_of("a", samples), benchmark_of("b", samples)}),
                      result_of({benchmark_of("b", samples), benchmark_of("c", samples)}));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].verdict, SpeedVerdict::nothing_measured);
  EXPECT_THAT(all[0].reason, HasSubstr("only base"));
  EXPECT_EQ(all[1].verdict, SpeedVerdict::same);
  EXPECT_EQ(all[2].name, "c");
  EXPECT_THROW(conclude_stored(result_of({benchmark_of("a", samples)}),
                               result_of({benchmark_of("b", samples)})),
               NothingSelected);
}

}  // namespace
}  // namespace phytobench
