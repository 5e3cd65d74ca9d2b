// SPDX-License-Identifier: MIT
#include "reports/judge/scaling.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using State = JudgedAim::State;

/// A run of an experiment "p/s", written measurement by measurement.
class MadeUpRun {
 public:
  explicit MadeUpRun(int rounds = 6) : rounds_(rounds) {}
  void count(const std::string& name, std::int64_t value) {
    run_.records.push_back({.experiment = "p/s", .measurement = "p/s/" + name, .value = value});
  }
  void size(int points) {
    const std::string at = std::to_string(points);
    count(at + "/points", points);
    count(at + "/nodes", points / 5);
    count(at + "/iterations", 10);
    count(at + "/floor/association_pairs", points);
    count(at + "/floor/removal_pairs", points / 4);
  }
  /// An exact entry that took about `seconds` in each round.
  void entry(int points, const std::string& name, double seconds, std::int64_t evaluations) {
    const std::string at = std::to_string(points) + "/" + name;
    count(at + "/exact", 1);
    count(at + "/evaluations", evaluations);
    for (int round = 0; round < rounds_; ++round) {
      sample(at + "/seconds", round, seconds * (1.0 + 0.01 * round));
      sample(at + "/growth_seconds", round, 0.5 * seconds);
    }
  }
  void sample(const std::string& name, std::int64_t round, double value) {
    run_.timings.push_back({.experiment = "p/s",
                            .measurement = "p/s/" + name,
                            .round = round,
                            .position = 0,
                            .value = value,
                            .threads = 1});
  }
  JudgedScaling judged(std::vector<Aim> aims = {}) const {
    const Evidence evidence(run_);
    return judge_scaling({.id = "s", .experiment = "p/s", .title = {}, .intro = {}, .aims = aims},
                         run_, evidence);
  }

 private:
  int rounds_;
  RunContents run_;
};

/// Time as points, and as points squared but cheaper at first.
MadeUpRun two_engines(int rounds = 6) {
  MadeUpRun run(rounds);
  for (const int points : {1000, 10000, 100000}) {
    run.size(points);
    run.entry(points, "fast.dn", 1e-6 * points, 3 * points);
    run.entry(points, "simple.dn", 1e-10 * points * points, std::int64_t{points} * points);
  }
  return run;
}

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

Aim ratio_aim(double must, double aim) {
  return {.kind = Aim::Kind::ratio,
          .text = {},
          .entries = {"simple.dn", "fast.dn"},
          .sizes = {100000},
          .must = must,
          .aim = aim,
          .limits = {}};
}

TEST(JudgeAim, ARatioIsReachedHalfReachedOrMissed) {
  const MadeUpRun run = two_engines();  // the ratio is 10 in every round
  EXPECT_EQ(run.judged({ratio_aim(5, 9)}).aims[0].state, State::reached);
  EXPECT_EQ(run.judged({ratio_aim(5, 20)}).aims[0].state, State::must_reached);
  EXPECT_EQ(run.judged({ratio_aim(15, 20)}).aims[0].state, State::missed);
  EXPECT_NEAR(run.judged({ratio_aim(5, 9)}).aims[0].measured.value, 10.0, 1e-9);
}

TEST(JudgeAim, IsOpenWhereTheIntervalHoldsTheBound) {
  MadeUpRun run;
  run.size(1000);
  run.entry(1000, "a.dn", 1.0, 1);
  run.count("1000/b.dn/exact", 1);
  for (int round = 0; round < 6; ++round)
    run.sample("1000/b.dn/seconds", round, 0.05 + 0.1 * round);
  Aim aim = ratio_aim(6, 1000);
  aim.entries = {"a.dn", "b.dn"};
  aim.sizes = {1000};
  const JudgedAim judged = run.judged({aim}).aims[0];
  EXPECT_EQ(judged.state, State::open);
  EXPECT_FALSE(judged.measured.is_only_range());
}

// Three equal ratios of 10 would be sure of themselves by a bootstrap.
TEST(JudgeAim, StaysOpenWithFewerThanSixRoundsAndShowsTheirRange) {
  for (const int rounds : {1, 3, 5, 6}) {
    const JudgedAim judged = two_engines(rounds).judged({ratio_aim(5, 9)}).aims[0];
    EXPECT_EQ(judged.state, rounds < 6 ? State::open : State::reached) << rounds;
    EXPECT_EQ(judged.measured.rounds, static_cast<std::size_t>(rounds));
    EXPECT_NEAR(judged.measured.low, 10.0, 1e-9);
    EXPECT_NEAR(judged.measured.high, 10.0, 1e-9);
  }
  EXPECT_EQ(two_engines(3).judged({ratio_aim(15, 20)}).aims[0].state, State::open) << "nor missed";
}

TEST(JudgeAim, DividesTimesPerPointByRoundsThatBothSizesHave) {
  MadeUpRun run(0);
  Aim aim = ratio_aim(1.8, 1.2);
  aim.kind = Aim::Kind::per_point;
  aim.entries = {"fast.dn"};
  aim.sizes = {100000, 1000};
  for (const int points : {1000, 100000}) {
    run.size(points);
    run.entry(points, "fast.dn", 1.0, points);
    for (int round = 0; round < (points == 1000 ? 25 : 7); ++round)
      run.sample(std::to_string(points) + "/fast.dn/seconds", round, 1e-6 * points);
  }
  const JudgedAim judged = run.judged({aim}).aims[0];
  EXPECT_EQ(judged.state, State::reached);
  EXPECT_EQ(judged.measured.rounds, 7u);
  EXPECT_NEAR(judged.measured.high, 1.0, 1e-9);
}

TEST(JudgeAim, DecidesOnCountsAndMemoryWithoutRounds) {
  MadeUpRun run = two_engines(3);
  for (const int points : {1000, 10000, 100000})
    run.sample(std::to_string(points) + "/fast.dn/bytes", 0, 50.0 * points);
  Aim memory = ratio_aim(64, 44);
  memory.kind = Aim::Kind::bytes_per_point;
  memory.entries = {"fast.dn"};
  memory.sizes = {};
  EXPECT_EQ(run.judged({memory}).aims[0].state, State::must_reached);
  EXPECT_EQ(run.judged({memory}).aims[0].measured.rounds, 0u);
}

TEST(JudgeAim, WithoutEvidenceIsNotMeasured) {
  Aim aim = ratio_aim(5, 9);
  aim.sizes = {5000};
  EXPECT_EQ(two_engines().judged({aim}).aims[0].state, State::not_measured);
  aim.entries = {"nobody.dn", "fast.dn"};
  EXPECT_EQ(two_engines().judged({aim}).aims[0].state, State::not_measured);
}

TEST(JudgeAim, LessIsBetterForAllButRatios) {
  const MadeUpRun run = two_engines();
  const auto state = [&](Aim::Kind kind, std::vector<double> sizes, double must, double aim) {
    return run
        .judged({{.kind = kind,
                  .text = {},
                  .entries = {"fast.dn"},
                  .sizes = std::move(sizes),
                  .must = must,
                  .aim = aim,
                  .limits = {}}})
        .aims[0];
  };
  const JudgedAim floor = state(Aim::Kind::over_floor, {}, 3, 2);
  EXPECT_EQ(floor.state, State::must_reached);
  EXPECT_DOUBLE_EQ(floor.measured.value, 2.4);
  EXPECT_FALSE(floor.varies) << "it is counted";
  EXPECT_EQ(state(Aim::Kind::over_floor, {}, 2, 1).state, State::missed);
  const JudgedAim per_point = state(Aim::Kind::per_point, {100000, 1000}, 1.8, 1.2);
  EXPECT_EQ(per_point.state, State::reached);
  EXPECT_NEAR(per_point.measured.value, 1.0, 1e-9);
  EXPECT_EQ(state(Aim::Kind::bytes_per_point, {}, 64, 44).state, State::not_measured);
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
