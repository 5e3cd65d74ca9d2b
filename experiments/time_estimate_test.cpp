// SPDX-License-Identifier: MIT
#include "experiments/time_estimate.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

constexpr ExperimentDescriptor short_one{
    .id = "fake/short", .question = "?", .source = "[Fake]", .seconds = {1.0, 2.0, 3.0}, .run = {}};
constexpr ExperimentDescriptor long_one{.id = "fake/long",
                                        .question = "?",
                                        .source = "[Fake]",
                                        .seconds = {95.0, 200.0, 300.0},
                                        .run = {}};

TEST(TimeEstimate, IsAtFirstWhatTheDescriptorsSayForTheTier) {
  EXPECT_DOUBLE_EQ(TimeEstimate(Tier::smoke).seconds_of(short_one), 1.0);
  EXPECT_DOUBLE_EQ(TimeEstimate(Tier::quick).seconds_of(short_one), 2.0);
  const ExperimentDescriptor* both[] = {&short_one, &long_one};
  EXPECT_DOUBLE_EQ(TimeEstimate(Tier::full).seconds_of(both), 303.0);
}

TEST(TimeEstimate, LearnsThePaceMostlyFromLongExperiments) {
  TimeEstimate after_short(Tier::smoke), after_long(Tier::smoke);
  after_short.learn(short_one, 3.0);
  after_long.learn(long_one, 3.0 * 95.0);
  EXPECT_GT(after_short.seconds_of(short_one), 1.0);
  EXPECT_LT(after_short.seconds_of(short_one), 1.5) << "one second says little";
  EXPECT_NEAR(after_long.seconds_of(short_one), 2.9, 1e-9);
}

TEST(TimeEstimateLaw, StaysWhereEverythingTakesWhatWasForetold) {
  TimeEstimate estimate(Tier::quick);
  for (const ExperimentDescriptor* experiment : {&short_one, &long_one, &short_one})
    estimate.learn(*experiment, experiment->seconds[1]);
  EXPECT_DOUBLE_EQ(estimate.seconds_of(long_one), 200.0);
}

TEST(ShownDuration, HasTheUnitsThatFit) {
  EXPECT_EQ(shown_duration(0.0), "0 s");
  EXPECT_EQ(shown_duration(0.256), "0.26 s");
  EXPECT_EQ(shown_duration(9.94), "9.9 s");
  EXPECT_EQ(shown_duration(9.96), "10 s");
  EXPECT_EQ(shown_duration(99.4), "99 s");
  EXPECT_EQ(shown_duration(185.0), "3 min 5 s");
  EXPECT_EQ(shown_duration(3599.4), "59 min 59 s");
  EXPECT_EQ(shown_duration(7620.0), "2 h 7 min");
}

}  // namespace
}  // namespace phytobench
