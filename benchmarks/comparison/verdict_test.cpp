// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/comparison_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// What is tested does not depend on the number of resamples.
constexpr VerdictSettings quick{.resamples = 400};

ConcludedBenchmark concluded(std::vector<BlockTimes> control, std::vector<BlockTimes> blocks,
                             const VerdictSettings& settings = quick) {
  Measured measured;
  measured.benchmarks = {measured_benchmark("b", std::move(control), std::move(blocks))};
  return conclude(measured, settings).at(0);
}

/// A control that reaches 1 % to either side at most.
std::vector<BlockTimes> quiet(int count = 10) {
  return even_blocks(count, 1.0, 0.01);
}

TEST(Conclude, FindsALossOfSpeed) {
  const ConcludedBenchmark slower = concluded(quiet(), even_blocks(10, 1.1, 0.01));
  EXPECT_EQ(slower.verdict, SpeedVerdict::slower);
  EXPECT_EQ(slower.name, "b");
  EXPECT_EQ(slower.blocks, 10u);
  EXPECT_NEAR(slower.ratio->value, 1.1, 1e-12);
  EXPECT_LT(slower.ratio->low, 1.1);
  EXPECT_GT(slower.ratio->high, 1.1);
  EXPECT_NEAR(slower.control->value, 1.0, 1e-12);
  EXPECT_GT(slower.noise_floor, 0.0);
  EXPECT_LE(slower.noise_floor, std::exp(0.01) - 1.0);
  EXPECT_DOUBLE_EQ(slower.p, 2.0 / 1024.0);
  EXPECT_THAT(slower.reason, StartsWith("+10.0 % ["));
  EXPECT_THAT(slower.reason,
              HasSubstr("], more than the 3 % that do not matter and the noise of "));
}

TEST(Conclude, FindsAGain) {
  const ConcludedBenchmark faster = concluded(quiet(), even_blocks(10, 0.9, 0.01));
  EXPECT_EQ(faster.verdict, SpeedVerdict::faster);
  EXPECT_DOUBLE_EQ(faster.p, 2.0 / 1024.0);
  EXPECT_THAT(faster.reason, StartsWith("-10.0 % [-"));
}

TEST(Conclude, SaysTheSameOfWhatDoesNotMatter) {
  const ConcludedBenchmark same = concluded(quiet(), even_blocks(10, 1.0, 0.01));
  EXPECT_EQ(same.verdict, SpeedVerdict::same);
  EXPECT_THAT(same.reason, StartsWith("+0.0 % [-"));
  EXPECT_THAT(same.reason, HasSubstr("], within the 3 % that do not matter"));
  // Surely a change, but a small one; it is one where that matters.
  const std::vector<BlockTimes> small = even_blocks(10, 1.02, 0.002);
  EXPECT_EQ(concluded(quiet(), small).verdict, SpeedVerdict::same);
  EXPECT_EQ(concluded(even_blocks(10, 1.0, 0.005), small, {.tolerance = 0.01}).verdict,
            SpeedVerdict::slower);
}

TEST(Conclude, DoesNotTakeDoubtForTheSame) {
  const ConcludedBenchmark wide = concluded(quiet(), even_blocks(10, 1.0, 0.2));
  EXPECT_EQ(wide.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(wide.reason, HasSubstr("too wide to exclude a change of 3 %"));
  const ConcludedBenchmark edge = concluded(quiet(), even_blocks(10, 1.03, 0.01));
  EXPECT_EQ(edge.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(edge.reason, HasSubstr("perhaps within the 3 % that do not matter"));
}

TEST(Conclude, ComparesAChangeWithTheNoise) {
  const std::vector<BlockTimes> noisy = even_blocks(10, 1.0, 0.3);
  const std::vector<BlockTimes> blocks = even_blocks(10, 1.1, 0.01);
  const ConcludedBenchmark lost = concluded(noisy, blocks);
  EXPECT_EQ(lost.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(lost.reason, HasSubstr("but here it must exceed "));
  // Without a look at the control it would be an alarm.
  EXPECT_EQ(concluded(noisy, blocks, {.noise_factor = 0.0, .resamples = 400}).verdict,
            SpeedVerdict::slower);
  // What is larger than the noise is found in spite of it.
  EXPECT_EQ(concluded(noisy, even_blocks(10, 1.5, 0.01)).verdict, SpeedVerdict::slower);
}

TEST(Conclude, NeverSaysTheSameWhereTheControlIsNoisy) {
  const ConcludedBenchmark noisy = concluded(even_blocks(10, 1.0, 0.3), quiet());
  EXPECT_EQ(noisy.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(noisy.reason, HasSubstr("but the same build differs from itself by up to "));
}

TEST(Conclude, TrustsNoInstrumentThatSeesAChangeInNothing) {
  const std::vector<BlockTimes> biased = even_blocks(10, 1.06, 0.002);
  for (const double ratio : {0.8, 1.0, 1.06, 1.5}) {
    const ConcludedBenchmark tripped = concluded(biased, even_blocks(10, ratio, 0.002));
    EXPECT_EQ(tripped.verdict, SpeedVerdict::inconclusive) << ratio;
    EXPECT_THAT(tripped.reason, StartsWith("the same build differs from itself by +6.0 % ["));
    EXPECT_EQ(tripped.p, 1.0);
  }
  // Another control would let the same bias pass for a change.
  EXPECT_EQ(concluded(quiet(), biased).verdict, SpeedVerdict::slower);
  // A bias within the tolerance is noise.
  EXPECT_EQ(concluded(even_blocks(10, 1.02, 0.002), even_blocks(10, 1.1, 0.002)).verdict,
            SpeedVerdict::slower);
}

TEST(Conclude, SaysNothingOfFewBlocks) {
  const ConcludedBenchmark few = concluded(quiet(), even_blocks(7, 1.5, 0.001));
  EXPECT_EQ(few.verdict, SpeedVerdict::inconclusive);
  EXPECT_EQ(few.reason, "7 of at least 8 blocks were measured");
  EXPECT_FALSE(few.ratio);
  const ConcludedBenchmark little_control = concluded(quiet(7), even_blocks(10, 1.5, 0.001));
  EXPECT_EQ(little_control.verdict, SpeedVerdict::inconclusive);
  EXPECT_EQ(little_control.reason, "7 of at least 8 blocks of the control were measured");
  EXPECT_EQ(concluded({}, quiet()).verdict, SpeedVerdict::inconclusive);
}

TEST(Conclude, NeedsNoTimesForSomeVerdicts) {
  Measured measured;
  measured.benchmarks.assign(3, measured_benchmark("b", quiet(), even_blocks(10, 1.5, 0.01)));
  measured.benchmarks[0].objection = "the last neighbour is wrong";
  measured.benchmarks[1].is_same_work = false;
  measured.benchmarks[2].blocks.clear();
  std::vector<ConcludedBenchmark> all = conclude(measured, quick);
  EXPECT_EQ(all[0].verdict, SpeedVerdict::wrong_answer);
  EXPECT_EQ(all[0].reason, "the last neighbour is wrong");
  EXPECT_EQ(all[1].verdict, SpeedVerdict::nothing_measured);
  EXPECT_THAT(all[1].reason, HasSubstr("inputs differ"));
  EXPECT_EQ(all[2].verdict, SpeedVerdict::nothing_measured);
  EXPECT_EQ(all[2].reason, "no block was finished");
  for (const ConcludedBenchmark& benchmark : all) EXPECT_FALSE(benchmark.ratio);
  // The same program can be wrong, but not slower.
  measured.is_same_program = true;
  all = conclude(measured, quick);
  EXPECT_EQ(all[0].verdict, SpeedVerdict::wrong_answer);
  EXPECT_EQ(all[1].verdict, SpeedVerdict::nothing_measured) << "other data, or no work at all";
  EXPECT_EQ(all[2].verdict, SpeedVerdict::same_binary);
  EXPECT_TRUE(conclude({}, quick).empty());
}

/// One benchmark that became slower, among others that did not.
Measured one_of(int benchmarks, int blocks) {
  Measured measured;
  for (int i = 0; i + 1 < benchmarks; ++i)
    measured.benchmarks.push_back(
        measured_benchmark("same", quiet(blocks), even_blocks(blocks, 1.0, 0.01)));
  measured.benchmarks.push_back(
      measured_benchmark("slower", quiet(blocks), even_blocks(blocks, 1.2, 0.01)));
  return measured;
}

TEST(Conclude, JudgesAllBenchmarksTogether) {
  const std::vector<ConcludedBenchmark> few = conclude(one_of(60, 10), quick);
  EXPECT_EQ(few.back().verdict, SpeedVerdict::inconclusive);
  EXPECT_NEAR(few.back().p, 60.0 * 2.0 / 1024.0, 1e-12);
  EXPECT_THAT(few.back().reason,
              HasSubstr("but 10 blocks are too few to judge 60 benchmarks together, it takes 12"));
  const std::vector<ConcludedBenchmark> enough = conclude(one_of(60, 12), quick);
  EXPECT_EQ(enough.back().verdict, SpeedVerdict::slower);
  EXPECT_EQ(std::count_if(enough.begin(), enough.end(),
                          [](const auto& each) { return each.verdict == SpeedVerdict::same; }),
            59);
}

TEST(Conclude, AdjustsForNoneThatWasNotTested) {
  Measured measured = one_of(60, 10);
  for (std::size_t i = 0; i < 20; ++i) measured.benchmarks[i].blocks.clear();
  for (std::size_t i = 20; i < 40; ++i) measured.benchmarks[i].control.resize(2);
  for (std::size_t i = 40; i < 59; ++i)
    measured.benchmarks[i].control = even_blocks(10, 1.2, 0.001);
  const std::vector<ConcludedBenchmark> all = conclude(measured, quick);
  EXPECT_EQ(all.back().verdict, SpeedVerdict::slower);
  EXPECT_DOUBLE_EQ(all.back().p, 2.0 / 1024.0);
}

// Fourteen of eighteen blocks agree, which convinces the interval; the others contradict strongly.
TEST(Conclude, BelievesNoIntervalAgainstTheTest) {
  std::vector<double> log_ratios(14, 0.2);
  for (const double against : {-0.3, -0.31, -0.32, -0.33}) log_ratios.push_back(against);
  const ConcludedBenchmark doubtful = concluded(quiet(), blocks_of(log_ratios));
  EXPECT_GT(doubtful.ratio->low, 1.03);
  EXPECT_EQ(doubtful.verdict, SpeedVerdict::inconclusive);
  EXPECT_THAT(doubtful.reason, HasSubstr("must be below 0.05"));
}

TEST(ConcludeLaw, SwappedSidesMirrorTheVerdict) {
  const auto swapped = [](std::vector<BlockTimes> blocks) {
    for (BlockTimes& block : blocks) std::swap(block.base, block.other);
    return blocks;
  };
  for (const double ratio : {0.85, 0.98, 1.003, 1.04, 1.2}) {
    const std::vector<BlockTimes> control = even_blocks(10, 1.004, 0.012);
    const std::vector<BlockTimes> blocks = even_blocks(10, ratio, 0.01);
    const ConcludedBenchmark one = concluded(control, blocks);
    const ConcludedBenchmark other = concluded(swapped(control), swapped(blocks));
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(one.ratio->low, 1.0 / other.ratio->high, rounding);
    EXPECT_NEAR(one.ratio->high, 1.0 / other.ratio->low, rounding);
    EXPECT_NEAR(one.noise_floor, other.noise_floor, rounding);
    EXPECT_NEAR(one.p, other.p, rounding);
    const auto mirrored = [](SpeedVerdict verdict) {
      if (verdict == SpeedVerdict::slower) return SpeedVerdict::faster;
      return verdict == SpeedVerdict::faster ? SpeedVerdict::slower : verdict;
    };
    EXPECT_EQ(one.verdict, mirrored(other.verdict)) << ratio;
  }
}

TEST(ConcludeLaw, FollowsAnyOrderOfTheBenchmarks) {
  Measured measured = one_of(5, 10);
  const std::vector<ConcludedBenchmark> forth = conclude(measured, quick);
  std::reverse(measured.benchmarks.begin(), measured.benchmarks.end());
  const std::vector<ConcludedBenchmark> back = conclude(measured, quick);
  for (std::size_t i = 0; i < forth.size(); ++i) {
    EXPECT_EQ(forth[i].name, back[4 - i].name);
    EXPECT_EQ(forth[i].verdict, back[4 - i].verdict);
    EXPECT_EQ(forth[i].reason, back[4 - i].reason);
    EXPECT_EQ(forth[i].p, back[4 - i].p);
  }
}

TEST(BlocksNeeded, LetsOneOfManyFallBelowAlpha) {
  EXPECT_EQ(blocks_needed(0), 8);
  EXPECT_EQ(blocks_needed(6), 8);
  EXPECT_EQ(blocks_needed(7), 9);
  EXPECT_EQ(blocks_needed(102), 12);
  EXPECT_EQ(blocks_needed(103), 13);
  EXPECT_EQ(blocks_needed(1, {.least_blocks = 1}), 6);
  EXPECT_EQ(blocks_needed(1, {.alpha = 0.01, .least_blocks = 1}), 8);
}

TEST(Conclude, RefusesSettingsOutOfRange) {
  EXPECT_THROW(conclude({}, {.tolerance = 0.0}), ContractViolation);
  EXPECT_THROW(conclude({}, {.tolerance = NAN}), ContractViolation);
  EXPECT_THROW(conclude({}, {.alpha = 1.0}), ContractViolation);
  EXPECT_THROW(conclude({}, {.noise_factor = -1.0}), ContractViolation);
  EXPECT_THROW(conclude({}, {.least_blocks = 0}), ContractViolation);
  EXPECT_THROW(conclude({}, {.resamples = 0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
