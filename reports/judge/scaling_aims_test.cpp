// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "reports/judge/made_up_scaling.hpp"

namespace phytobench {
namespace {

using State = JudgedAim::State;

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

// The ratio lies between 11 and 13: the least is certain, and the aim of 12 is neither reached nor
// missed.
TEST(JudgeAim, LeavesTheAimOpenWhereTheIntervalHoldsIt) {
  MadeUpRun run;
  run.size(1000);
  run.count("1000/a.dn/exact", 1);
  run.entry(1000, "b.dn", 1.0, 1);
  for (int round = 0; round < 6; ++round)
    run.sample("1000/a.dn/seconds", round, (11.0 + 0.4 * round) * (1.0 + 0.01 * round));
  const auto judged = [&](double must, double bound) {
    Aim aim = ratio_aim(must, bound);
    aim.entries = {"a.dn", "b.dn"};
    aim.sizes = {1000};
    return run.judged({aim}).aims[0];
  };
  EXPECT_EQ(judged(5, 12).state, State::must_reached_aim_open);
  EXPECT_FALSE(judged(5, 12).surely_misses_its_aim());
  EXPECT_EQ(judged(5, 14).state, State::must_reached);
  EXPECT_TRUE(judged(5, 14).surely_misses_its_aim());
  EXPECT_EQ(judged(5, 10).state, State::reached);
  EXPECT_EQ(judged(12, 14).state, State::open) << "of the least";
  EXPECT_TRUE(judged(12, 14).surely_misses_its_aim());
  EXPECT_EQ(judged(14, 20).state, State::missed);
}

// The time per point is 1.1 to 1.3 times as large.
TEST(JudgeAim, LeavesAnAimOfLessOpenToo) {
  MadeUpRun run;
  run.size(1000);
  run.size(2000);
  run.entry(1000, "fast.dn", 1.0, 1);
  run.count("2000/fast.dn/exact", 1);
  for (int round = 0; round < 6; ++round)
    run.sample("2000/fast.dn/seconds", round, (2.2 + 0.08 * round) * (1.0 + 0.01 * round));
  const auto state = [&](double must, double bound) {
    Aim aim = ratio_aim(must, bound);
    aim.kind = Aim::Kind::per_point;
    aim.entries = {"fast.dn"};
    aim.sizes = {2000, 1000};
    return run.judged({aim}).aims[0].state;
  };
  EXPECT_EQ(state(1.8, 1.2), State::must_reached_aim_open);
  EXPECT_EQ(state(1.8, 1.0), State::must_reached);
  EXPECT_EQ(state(1.8, 1.4), State::reached);
  EXPECT_EQ(state(1.2, 1.0), State::open);
  EXPECT_EQ(state(1.0, 0.5), State::missed);
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

}  // namespace
}  // namespace phytobench
