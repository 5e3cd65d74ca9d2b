// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instrument_verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// All as it must be.
InstrumentCheck good() {
  return {.alike = {.same = 40},
          .handicapped = {.slower = 10},
          .wanted_alike = 40,
          .wanted_handicapped = 10,
          .handicap = 0.1,
          .noise_floor = 0.01,
          .refusals = {{"a", "refused", "wrong answer", true}}};
}

InstrumentState state_of(const InstrumentCheck& check) {
  return judge_instrument(check).state;
}

TEST(InstrumentVerdict, IsProvenWhereAllHolds) {
  EXPECT_EQ(state_of(good()), InstrumentState::proven);
  EXPECT_THAT(judge_instrument(good()).reasons, IsEmpty());
  InstrumentCheck check = good();
  check.alike = {.slower = 1, .faster = 1, .same = 30, .inconclusive = 8};
  check.handicapped = {.slower = 9, .inconclusive = 1};
  EXPECT_EQ(state_of(check), InstrumentState::proven);
}

TEST(InstrumentVerdict, IsBrokenIfSomethingBrokenWasNotRefused) {
  InstrumentCheck check = good();
  check.refusals.front().is_refused = false;
  EXPECT_EQ(state_of(check), InstrumentState::broken);
  EXPECT_THAT(judge_instrument(check).reasons.front(), HasSubstr("demanded was 'refused'"));
}

TEST(InstrumentVerdict, IsBrokenByFalseAlarmsBeyondChance) {
  InstrumentCheck check = good();
  check.alike = {.slower = 3, .same = 37};
  EXPECT_EQ(state_of(check), InstrumentState::unproven) << "7.5 %, which may be chance";
  check.alike = {.slower = 3, .faster = 3, .same = 34};
  EXPECT_EQ(state_of(check), InstrumentState::broken) << "15 %, surely above 5 %";
}

TEST(InstrumentVerdict, CountsAlarmsOfUsualComparisons) {
  InstrumentCheck check = good();
  check.wanted_usual = 4;
  EXPECT_EQ(state_of(check), InstrumentState::unproven) << "they are missing";
  check.usual = {.same = 3, .inconclusive = 1};
  EXPECT_EQ(state_of(check), InstrumentState::proven);
  EXPECT_EQ(false_alarms(check).value, 0.0);
  check.usual = {.slower = 2, .faster = 1, .same = 1};
  EXPECT_EQ(state_of(check), InstrumentState::unproven) << "3 of 44, which may be chance";
  EXPECT_NEAR(false_alarms(check).value, 3.0 / 44.0, 1e-12);
  check.usual = {.same = 3, .other = 1};
  EXPECT_EQ(state_of(check), InstrumentState::broken);
}

TEST(InstrumentVerdict, IsBrokenByMissedLossesBeyondChance) {
  InstrumentCheck check = good();
  check.handicapped = {.slower = 8, .same = 2};
  EXPECT_EQ(state_of(check), InstrumentState::unproven);
  check.handicapped = {.slower = 5, .same = 5};
  EXPECT_EQ(state_of(check), InstrumentState::broken);
  check.handicapped = {.slower = 5, .inconclusive = 5};
  EXPECT_EQ(state_of(check), InstrumentState::broken) << "on a quiet machine nothing hides a loss";
}

TEST(InstrumentVerdict, IsUnprovenOnANoisyMachine) {
  InstrumentCheck check = good();
  check.alike = {.inconclusive = 40};
  check.handicapped = {.inconclusive = 10};
  check.noise_floor = 0.3;
  const InstrumentVerdict verdict = judge_instrument(check);
  EXPECT_EQ(verdict.state, InstrumentState::unproven);
  ASSERT_EQ(verdict.reasons.size(), 2u);
  EXPECT_THAT(verdict.reasons[0], HasSubstr("too noisy"));
  EXPECT_THAT(verdict.reasons[1], HasSubstr("noise"));
  check.handicapped = {.same = 10};
  EXPECT_EQ(state_of(check), InstrumentState::broken) << "'same' is no doubt";
}

TEST(InstrumentVerdict, IsUnprovenIfTimeEndedFirst) {
  InstrumentCheck check = good();
  check.alike = {.same = 20};
  EXPECT_EQ(state_of(check), InstrumentState::unproven);
  check.alike = check.handicapped = {};
  EXPECT_EQ(state_of(check), InstrumentState::unproven);
}

TEST(InstrumentVerdict, IsBrokenIfRightAnswersAreNotTimed) {
  InstrumentCheck check = good();
  check.alike = {.same = 39, .other = 1};
  EXPECT_EQ(state_of(check), InstrumentState::broken);
}

TEST(InstrumentVerdict, StaysBrokenWhateverElseIsWrong) {
  InstrumentCheck check = good();
  check.refusals.front().is_refused = false;
  check.alike = {.inconclusive = 20};
  EXPECT_EQ(state_of(check), InstrumentState::broken);
}

}  // namespace
}  // namespace phytobench
