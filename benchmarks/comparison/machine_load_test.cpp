// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/machine_load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(ProcessorTicks, AreThoseOfAllProcessorsWithoutGuestsTwice) {
  const ProcessorTicks ticks = processor_ticks_from(
      "cpu  100 20 30 4000 50 6 7 80 90 10\ncpu0 1 1 1 1 1 1 1 1 1 1\nintr 5\n");
  EXPECT_EQ(ticks.total, 4293u);
  EXPECT_EQ(ticks.idle, 4050u);
  EXPECT_EQ(ticks.steal, 80u);
}

TEST(ProcessorTicks, OfOldSystemsKnowNoSteal) {
  const ProcessorTicks ticks = processor_ticks_from("cpu 1 2 3 4\n");
  EXPECT_EQ(ticks.total, 10u);
  EXPECT_EQ(ticks.steal, 0u);
}

TEST(ProcessorTicks, OfAnotherFormAreErrors) {
  for (const char* text : {"", "\n", "cpu", "cpu 1 2 3", "cpu0 1 2 3 4 5 6 7 8", "cpu a b c d",
                           "intr 1 2 3 4 5 6 7 8", "cpu 1 2 x 4 5 6 7 8"})
    EXPECT_THROW(processor_ticks_from(text), EnvironmentError) << text;
}

TEST(ProcessorTicks, OfThisMachineDoNotGoBackwards) {
  const ProcessorTicks before = processor_ticks(), after = processor_ticks();
  EXPECT_GT(before.total, 0u);
  EXPECT_GE(after.steal, before.steal);
}

TEST(Shares, ArePartsOfTheTimeBetweenReadings) {
  const ProcessorTicks before{.total = 1000, .idle = 800, .steal = 10};
  const ProcessorTicks after{.total = 1200, .idle = 900, .steal = 14};
  EXPECT_DOUBLE_EQ(steal_share(before, after), 0.02);
  EXPECT_DOUBLE_EQ(busy_share(before, after), 0.5);
}

TEST(Shares, AreNothingWhereNoTimePassedOrTicksWentBack) {
  const ProcessorTicks before{.total = 1000, .idle = 800, .steal = 10};
  for (const ProcessorTicks& after :
       {before, ProcessorTicks{.total = 990, .idle = 795, .steal = 12},
        ProcessorTicks{.total = 1100, .idle = 950, .steal = 9}}) {
    EXPECT_EQ(steal_share(before, after), 0.0);
    EXPECT_EQ(busy_share(before, after), 0.0);
  }
}

TEST(StealMeters, GiveSharesAgainAndAgain) {
  StealMeter meter;
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT(meter.share_since_last(), testing::AllOf(testing::Ge(0.0), testing::Le(1.0)));
}

TEST(LoadAverage, IsNotNegative) {
  EXPECT_GE(load_average(), 0.0);
}

}  // namespace
}  // namespace phytobench
