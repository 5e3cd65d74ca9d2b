// SPDX-License-Identifier: MIT
#include "reference/lesser2019_switches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(LesserSwitches, AreReadAndShown) {
  EXPECT_EQ(shown(lesser_switches("none")), "none");
  EXPECT_EQ(shown(lesser_switches("E16,E13")), "E13,E16");
  EXPECT_EQ(lesser_switches("multiply-evaporation"), lesser_switches("E16"));
  EXPECT_EQ(shown(lesser_switches("all")),
            "E01,E03,E04,E07,E08,E09,E10,E12,E13,E16,E18,E19,rounded-sun");
  EXPECT_EQ(lesser_switches(shown(lesser_switches("all"))), lesser_switches("all"));
  EXPECT_EQ(lesser_switches("e16, Multiply-Evaporation ,E13 "), lesser_switches("E16,E13"));
  for (const char* wrong : {"", "E99", "E16,", "E16,,E13", "E06"}) {
    try {
      lesser_switches(wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("E16 (multiply-evaporation)")) << wrong;
      EXPECT_THAT(error.what(), HasSubstr("all (without E02,")) << wrong;
    }
  }
}

TEST(LesserSwitches, NoneStandsAlone) {
  EXPECT_EQ(lesser_switches("None"), LesserSwitches{});
  for (const char* wrong : {"none,E16", "E16,none"}) {
    try {
      lesser_switches(wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("give it alone")) << wrong;
    }
  }
}

TEST(LesserSwitches, AllSaysWhatItLeavesOut) {
  EXPECT_EQ(
      left_out_of_all(),
      "E02, E14, E15, E21, which only the text has, and E22, E23, which only saved maps have");
  const LesserSwitches all = lesser_switches("all");
  for (const char* left_out : {"E02", "E14", "E15", "E21", "E22", "E23"}) {
    EXPECT_TRUE(can_be_left_in(left_out));
    EXPECT_FALSE(all.has(*lesser_switches(left_out).printed.begin())) << left_out;
  }
  EXPECT_FALSE(can_be_left_in("E05"));
}

}  // namespace
}  // namespace phytobench
