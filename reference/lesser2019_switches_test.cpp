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
  for (const char* wrong : {"", "E99", "E16,", "E16 ,E13", "E06"}) {
    try {
      lesser_switches(wrong);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("E16 (multiply-evaporation)")) << wrong;
    }
  }
}

}  // namespace
}  // namespace phytobench
