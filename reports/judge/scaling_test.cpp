// SPDX-License-Identifier: MIT
#include "reports/judge/scaling.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "reports/judge/made_up_scaling.hpp"

namespace phytobench {
namespace {

const ScaledEntry& entry_of(const JudgedScaling& judged, const std::string& name) {
  for (const ScaledEntry& entry : judged.entries)
    if (entry.name == name) return entry;
  throw std::out_of_range(name);
}

TEST(JudgeScaling, FindsNothingInARunWithoutTheExperiment) {
  MadeUpRun run;
  run.count("other", 1);
  EXPECT_FALSE(run.judged().measured());
  EXPECT_TRUE(run.judged().entries.empty());
}

TEST(JudgeScaling, FitsTheExponentsOfTimeAndWork) {
  const JudgedScaling judged = two_engines().judged();
  ASSERT_TRUE(judged.measured());
  EXPECT_NEAR(entry_of(judged, "fast.dn").time_law->exponent.value, 1.0, 1e-9);
  EXPECT_NEAR(entry_of(judged, "simple.dn").time_law->exponent.value, 2.0, 1e-9);
  EXPECT_NEAR(entry_of(judged, "fast.dn").work_law->exponent.value, 1.0, 1e-9);
  EXPECT_NEAR(entry_of(judged, "simple.dn").work_law->exponent.high, 2.0, 1e-9);
}

TEST(JudgeScaling, DividesWorkByTheFloorOfItsOwnSize) {
  const JudgedScaling judged = two_engines().judged();
  EXPECT_DOUBLE_EQ(*entry_of(judged, "fast.dn").at.at(1000).over_floor, 3000 / 1250.0);
  EXPECT_DOUBLE_EQ(*entry_of(judged, "simple.dn").at.at(10000).over_floor, 1e8 / 12500.0);
  EXPECT_EQ(judged.sizes.at(100000).association_pairs, 100000);
}

// 1e-10 n^2 = 1e-6 n at n = 10,000, where neither is certainly faster.
TEST(JudgeScaling, NamesWhereCurvesCross) {
  const JudgedScaling judged = two_engines().judged();
  ASSERT_EQ(judged.crossovers.size(), 1u);
  const Crossover& crossover = judged.crossovers[0];
  EXPECT_EQ(crossover.overtaken, "simple.dn");
  EXPECT_EQ(crossover.overtaking, "fast.dn");
  EXPECT_EQ(crossover.low, 1000);
  EXPECT_EQ(crossover.high, 100000);
  EXPECT_NEAR(crossover.about, 10000, 1e-6);
  EXPECT_EQ(crossover.rounds, 6u);
  EXPECT_FALSE(crossover.is_open());
}

TEST(JudgeScaling, LeavesACrossoverOfFewRoundsOpen) {
  const JudgedScaling judged = two_engines(3).judged();
  ASSERT_EQ(judged.crossovers.size(), 1u);
  EXPECT_EQ(judged.crossovers[0].rounds, 3u);
  EXPECT_TRUE(judged.crossovers[0].is_open());
}

TEST(JudgeScaling, FindsNoCrossoverWhereTheRoundsDisagree) {
  MadeUpRun run(0);
  for (const int points : {1000, 10000}) {
    run.size(points);
    const std::string at = std::to_string(points);
    for (const char* name : {"a.dn", "b.dn"}) run.entry(points, name, 1.0, 1);
    for (int round = 0; round < 6; ++round) {
      run.sample(at + "/b.dn/seconds", round, 1.0);
      // Slower at the larger size, but for one round of six.
      run.sample(at + "/a.dn/seconds", round, points == 1000 || round == 0 ? 0.5 : 2.0);
    }
  }
  EXPECT_TRUE(run.judged().crossovers.empty());
}

TEST(JudgeScaling, CurvesThatDoNotCrossGiveNoCrossover) {
  MadeUpRun run;
  for (const int points : {1000, 10000}) {
    run.size(points);
    run.entry(points, "a.dn", 1e-6 * points, points);
    run.entry(points, "b.dn", 2e-6 * points, points);
  }
  EXPECT_TRUE(run.judged().crossovers.empty());
}

TEST(JudgeScaling, AnEngineGrownFartherComesFirst) {
  MadeUpRun run = two_engines();
  run.size(1000000);
  run.entry(1000000, "far.dn", 1e6, 1);
  const JudgedScaling judged = run.judged();
  EXPECT_EQ(judged.entries[0].name, "far.dn");
  EXPECT_EQ(judged.entries[1].name, "fast.dn");
  EXPECT_FALSE(judged.entries[0].time_law) << "one size is no law";
}

TEST(JudgeScaling, AnInexactEntryIsListedWithoutNumbers) {
  MadeUpRun run = two_engines();
  run.count("1000/wrong.dn/exact", 0);
  const JudgedScaling judged = run.judged();
  const auto& at = entry_of(judged, "wrong.dn").at.at(1000);
  EXPECT_FALSE(at.exact);
  EXPECT_FALSE(at.seconds);
  EXPECT_FALSE(at.over_floor);
}

TEST(JudgeScaling, HoldsPhasesAndMemory) {
  MadeUpRun run = two_engines();
  run.sample("1000/fast.dn/bytes", 0, 61000);
  const JudgedScaling judged = run.judged();
  const auto& at = entry_of(judged, "fast.dn").at.at(1000);
  EXPECT_DOUBLE_EQ(at.phase_seconds.at("growth"), 0.5e-3);
  EXPECT_FALSE(at.phase_seconds.contains("kill"));
  EXPECT_DOUBLE_EQ(*at.bytes_per_point, 61.0);
}

TEST(ScalingStudy, OfNearestNodeEnginesIsComplete) {
  const ScalingStudy study = load_scaling_study("nearest-node");
  EXPECT_EQ(study.experiment, "brzoska2019/scaling");
  EXPECT_GE(study.aims.size(), 8u);
  for (const Aim& aim : study.aims) {
    EXPECT_FALSE(aim.text.empty());
    if (aim.more_is_better())
      EXPECT_LT(aim.must, aim.aim) << aim.text;
    else
      EXPECT_GT(aim.must, aim.aim) << aim.text;
  }
  EXPECT_THROW(load_scaling_study("nothing"), InputError);
}

}  // namespace
}  // namespace phytobench
