// SPDX-License-Identifier: MIT
#include "reports/svg_path_data.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(SpacelessPathData, KeepsTheSpaceBetweenNumbersOnly) {
  EXPECT_EQ(spaceless_path_data("M1,2 L3,4\n\t\tL5 6  "), "M1,2L3,4L5 6");
}

TEST(StepwisePathData, GoesFromCornerToCorner) {
  EXPECT_EQ(stepwise_path_data("M10.04,20L15.06,20L15.06,18L16.1,17.5"), "M10 20h5.1v-2l1-.5");
  EXPECT_EQ(stepwise_path_data("M0 0L1 1L2 3L1 1"), "M0 0l1 1 1 2-1-2");
}

TEST(StepwisePathData, DoesNotAddUpWhatItRounds) {
  std::string corners = "M0,0";
  for (int i = 1; i <= 100; ++i) corners += "L0," + std::to_string(i * 0.14);
  const std::string steps = stepwise_path_data(corners);
  long tenths = 0;
  for (std::size_t at = steps.find('v'); at != std::string::npos; at = steps.find('v', at + 1))
    tenths += std::lround(10.0 * std::stod("0" + steps.substr(at + 1)));
  EXPECT_EQ(tenths, 140);
}

TEST(StepwisePathData, KeepsDotsAndBeginsAgainAfterAClosedLine) {
  EXPECT_EQ(stepwise_path_data("M100 50h0M101 50h0"), "M100 50h0m1 0h0");
  EXPECT_EQ(stepwise_path_data("M5 5L105 5L105 99zM6 6L7 7"), "M5 5h100v94zM6 6l1 1");
  EXPECT_EQ(stepwise_path_data("M1 1L1 1"), "M1 1h0") << "a line's only step is a dot";
}

TEST(StepwisePathData, LeavesWhatItDoesNotKnow) {
  for (const char* data : {"M1 2a3 3 0 1 0 6 0", "m1 2l3 4", "M1", "M1 2Lx", "1 2"})
    EXPECT_EQ(stepwise_path_data(data), data);
}

TEST(IsInTenths, CountsDecimals) {
  EXPECT_TRUE(is_in_tenths("M1.5.5L12 345.6h0"));
  EXPECT_FALSE(is_in_tenths("M1.5 0.25"));
}

TEST(IsInTenths, TakesNoExponent) {
  EXPECT_FALSE(is_in_tenths("M1e-05 2"));
  EXPECT_FALSE(is_in_tenths("M1.5E-3 2"));
  EXPECT_EQ(stepwise_path_data("M1e-05 2L3 4"), "M0 2l3 2") << "rounded like any other";
}

}  // namespace
}  // namespace phytobench
