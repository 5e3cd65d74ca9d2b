// SPDX-License-Identifier: MIT
#include "core/statistics/running_moments.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(RunningMoments, AreThoseOfTheDefinition) {
  RunningMoments m;
  for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) m.add(value);
  EXPECT_EQ(m.count(), 8);
  EXPECT_DOUBLE_EQ(m.mean(), 5.0);
  EXPECT_DOUBLE_EQ(m.variance(), 32.0 / 7.0);
  EXPECT_DOUBLE_EQ(m.standard_error(), std::sqrt(32.0 / 7.0 / 8.0));
  EXPECT_EQ(m.least(), 2.0);
  EXPECT_EQ(m.largest(), 9.0);
}

TEST(RunningMoments, KeepTheirDigitsFarFromZero) {
  RunningMoments m;
  for (const double value : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) m.add(value);
  EXPECT_DOUBLE_EQ(m.variance(), 30.0);
}

TEST(RunningMoments, OfTooFewValuesAreNotANumber) {
  RunningMoments m;
  EXPECT_TRUE(std::isnan(m.mean()));
  m.add(3.0);
  EXPECT_EQ(m.mean(), 3.0);
  EXPECT_TRUE(std::isnan(m.variance()));
  EXPECT_TRUE(std::isnan(m.standard_error()));
}

}  // namespace
}  // namespace phytobench
