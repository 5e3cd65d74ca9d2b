// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instrument_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/instrument_verdict.hpp"
#include "benchmarks/comparison/simulated_sides.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// The self-test on a simulated machine, with benchmarks that a test may mend or break.
class CheckedInstrument : public testing::Test {
 protected:
  SimulatedMachine machine_;
  std::map<std::string, SimulatedBenchmark> benchmarks_ = {
      {"selftest/steady", {}},
      {"selftest/wrong-answer", {.objection = "another node"}},
      {"selftest/forgets-work", {.sampling_objection = "another answer than before"}},
      {"selftest/stops-working", {.sampling_objection = "no time that can be measured"}},
      {"selftest/measures-nothing", {.iterations = 0}},
      {"own/one", {}},
      {"own/another", {.seconds = 2e-3}}};
  double hidden_share_ = 0.0;  ///< of the handicap, which the simulated build does not have
  InstrumentRequest request_{.repetitions = 8, .slow_repetitions = 2, .seed = 1};

  InstrumentCheck check() {
    request_.side = [&](double handicap) -> std::unique_ptr<TimedSide> {
      auto slowed = benchmarks_;
      slowed.at("selftest/steady").seconds *= 1.0 + handicap * (1.0 - hidden_share_);
      return std::make_unique<SimulatedSide>(machine_, handicap > 0.0 ? 'H' : 'A', slowed);
    };
    request_.stolen_share = [&] { return machine_.take_stolen_share(); };
    request_.clock_s = [&] { return machine_.clock_s; };
    return check_instrument(request_);
  }
};

TEST_F(CheckedInstrument, FindsWhatIsThereAndNothingElse) {
  machine_.noise = 0.003;
  const InstrumentCheck found = check();
  EXPECT_EQ(found.alike.same, 8);
  EXPECT_EQ(found.handicapped.slower, 2);
  EXPECT_NEAR(found.found_handicap, 0.1, 0.005);
  EXPECT_LT(found.noise_floor, 0.01);
  ASSERT_EQ(found.refusals.size(), 4u);
  for (const RefusalCheck& refusal : found.refusals)
    EXPECT_TRUE(refusal.is_refused) << refusal.benchmark << " " << refusal.found;
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::proven);
}

TEST_F(CheckedInstrument, NoticesWrongAnswersThatPass) {
  benchmarks_["selftest/wrong-answer"].objection = "";
  const InstrumentCheck found = check();
  EXPECT_FALSE(found.refusals[0].is_refused);
  EXPECT_THAT(found.refusals[0].found, HasSubstr("it was given times"));
  EXPECT_TRUE(found.refusals[1].is_refused);
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::broken);
}

TEST_F(CheckedInstrument, NoticesWorkThatIsForgottenUnseen) {
  benchmarks_["selftest/forgets-work"].sampling_objection = "";
  EXPECT_FALSE(check().refusals[1].is_refused);
}

TEST_F(CheckedInstrument, NoticesATimeOfNothing) {
  benchmarks_["selftest/measures-nothing"].iterations = 10;
  EXPECT_FALSE(check().refusals[3].is_refused);
}

TEST_F(CheckedInstrument, NoticesTimesOfWhatNoLongerWorks) {
  benchmarks_["selftest/stops-working"].sampling_objection = "";
  const InstrumentCheck found = check();
  EXPECT_FALSE(found.refusals[2].is_refused);
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::broken);
}

TEST_F(CheckedInstrument, ComparesBenchmarksOfTheSuiteAsCompareDoes) {
  machine_.noise = 0.04;  // enough for more blocks than the least
  request_.repetitions = request_.slow_repetitions = 1;
  request_.usual_names = {"own/one", "own/another"};
  request_.usual_repetitions = 3;
  const InstrumentCheck found = check();
  EXPECT_EQ(found.wanted_usual, 3);
  EXPECT_EQ(found.usual.all(), 3);
  EXPECT_EQ(found.usual.slower + found.usual.faster + found.usual.other, 0);
  // Both are timed in one process, until one of them is done.
  const TimingSettings usual;
  std::size_t both = 0, alone = 0;
  for (const SamplePlan& plan : machine_.plans) {
    if (!plan.benchmarks.front().name.starts_with("own/")) continue;
    EXPECT_EQ(plan.samples, usual.samples);
    ++(plan.benchmarks.size() == 2 ? both : alone);
  }
  EXPECT_GE(both, 3u * 2u * 4u * static_cast<std::size_t>(usual.least_blocks));
  EXPECT_GT(alone, 0u) << "no interval was narrow before the other";
}

TEST_F(CheckedInstrument, UsualComparisonsEndWithTheirBudget) {
  machine_.noise = 1.5;  // no interval ever is narrow
  request_.repetitions = request_.slow_repetitions = 1;
  request_.usual_names = {"own/one", "own/another"};
  request_.usual_repetitions = 4;
  request_.most_s = 100.0;  // 10 s each; a block takes 4 x 5 x 10 x (1 + 2) ms = 0.6 s and more
  const InstrumentCheck found = check();
  EXPECT_EQ(found.usual.inconclusive, 4);
  EXPECT_LT(found.seconds, 100.0);
}

TEST_F(CheckedInstrument, SeesAWrongAnswerInAUsualComparison) {
  benchmarks_["own/another"].sampling_objection = "another answer than before";
  request_.usual_names = {"own/one", "own/another"};
  request_.usual_repetitions = 1;
  EXPECT_EQ(check().usual.other, 1);
}

TEST(TimedBuild, IsNotOneThatCounts) {
  EXPECT_NO_THROW(refuse_to_time_counters({.counts_work = false}, "this build"));
  try {
    refuse_to_time_counters({.counts_work = true}, "this build");
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("this build: was built with work counters"));
  }
}

TEST_F(CheckedInstrument, MissesALossThatIsNotThere) {
  machine_.noise = 0.003;
  hidden_share_ = 1.0;
  request_.slow_repetitions = 10;
  const InstrumentCheck found = check();
  EXPECT_EQ(found.handicapped.slower, 0);
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::broken);
}

TEST_F(CheckedInstrument, OnANoisyMachineProvesNothing) {
  machine_.noise = 1.5;
  const InstrumentCheck found = check();
  EXPECT_EQ(found.alike.same, 0);
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::unproven);
}

TEST_F(CheckedInstrument, EndsInTimeWithBothKindsOfComparisons) {
  machine_.noise = 0.003;
  request_.repetitions = 400;
  request_.slow_repetitions = 100;
  request_.most_s = 100.0;  // a comparison takes 2 x 10 x 4 x 3 x 10 ms = 2.4 s
  const InstrumentCheck found = check();
  EXPECT_GT(found.alike.all(), 20);
  EXPECT_GT(found.handicapped.all(), 5);
  EXPECT_LT(found.seconds, 104.0);
  EXPECT_EQ(judge_instrument(found).state, InstrumentState::unproven);
}

TEST_F(CheckedInstrument, IsInterrupted) {
  request_.is_interrupted = [&] { return machine_.started.size() > 150; };
  EXPECT_THROW(check(), Interrupted);
}

TEST_F(CheckedInstrument, RefusesToCompareNothing) {
  request_.repetitions = 0;
  EXPECT_THROW(check(), ContractViolation);
}

}  // namespace
}  // namespace phytobench
