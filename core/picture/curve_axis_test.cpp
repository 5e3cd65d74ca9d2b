// SPDX-License-Identifier: MIT
#include "core/picture/curve_axis.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr AxisScale linear = AxisScale::linear, logarithmic = AxisScale::logarithmic;

std::vector<std::string> labels(const CurveAxis& axis) {
  std::vector<std::string> all;
  for (const AxisTick& tick : axis.ticks())
    if (!tick.label.empty()) all.push_back(tick.label);
  return all;
}

using Labels = std::vector<std::string>;

TEST(CurveAxis, NamesRoundNumbers) {
  EXPECT_EQ(labels(CurveAxis({0, 50}, linear)), (Labels{"0", "10", "20", "30", "40", "50"}));
  EXPECT_EQ(labels(CurveAxis({-0.3, 0.3}, linear)),
            (Labels{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(labels(CurveAxis({1e7, 3e7}, linear)),
            (Labels{"1e+07", "1.5e+07", "2e+07", "2.5e+07", "3e+07"}));
  EXPECT_EQ(labels(CurveAxis({0.5, 2000}, logarithmic)), (Labels{"1", "10", "100", "1000"}));
  EXPECT_EQ(labels(CurveAxis({1, 20}, logarithmic)), (Labels{"1", "2", "5", "10", "20"}));
  EXPECT_EQ(labels(CurveAxis({3, 6}, logarithmic)),
            (Labels{"3.0", "3.5", "4.0", "4.5", "5.0", "5.5", "6.0"}));
}

TEST(CurveAxisLaw, TicksLieInsideInOrderUnderNamesOfTheirOwnForEveryRange) {
  for (const AxisScale scale : {linear, logarithmic})
    for (int power = -12; power <= 12; ++power)
      for (double high = 1.05; high < 12.0; high *= 1.1) {
        const double unit = std::pow(10.0, power);
        const CurveAxis axis({unit, high * unit}, scale);
        SCOPED_TRACE(high * unit);
        const auto ticks = axis.ticks();
        std::set<std::string> named;
        double last = 0.0;
        for (const AxisTick& tick : ticks) {
          EXPECT_GE(tick.value, unit);
          EXPECT_LE(tick.value, high * unit);
          EXPECT_GT(tick.value, last);
          last = tick.value;
          if (tick.label.empty()) continue;
          EXPECT_TRUE(named.insert(tick.label).second) << tick.label;
        }
        EXPECT_GE(named.size(), 3u);
        EXPECT_LE(named.size(), 10u);
      }
}

TEST(CurveAxisLaw, NumbersOfALogarithmicAxisStandApart) {
  for (const double low : {0.013, 0.05, 0.1, 0.3, 1.0, 7.0})
    for (double ratio = 1.3; ratio < 900.0; ratio *= 1.07) {
      SCOPED_TRACE(ratio);
      const CurveAxis axis({low, ratio * low}, logarithmic);
      double last = -1.0;
      for (const AxisTick& tick : axis.ticks()) {
        if (tick.label.empty()) continue;
        EXPECT_GE(axis.position(tick.value) - last, 0.1) << tick.label;
        last = axis.position(tick.value);
      }
    }
}

TEST(CurveAxis, PositionsRunFromEndToEnd) {
  const CurveAxis plain({2, 6}, linear), decades({1, 10000}, logarithmic);
  EXPECT_EQ(plain.position(2), 0.0);
  EXPECT_EQ(plain.position(3), 0.25);
  EXPECT_EQ(plain.position(6), 1.0);
  EXPECT_EQ(plain.position(10), 2.0);
  for (int power = 0; power <= 4; ++power)
    EXPECT_NEAR(decades.position(std::pow(10.0, power)), 0.25 * power, 1e-15);
}

TEST(CurveAxis, RefusesRangesThatCannotBeDrawn) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(CurveAxis({1, 1}, linear), ContractViolation);
  EXPECT_THROW(CurveAxis({2, 1}, linear), ContractViolation);
  EXPECT_THROW(CurveAxis({0, infinity}, linear), ContractViolation);
  EXPECT_THROW(CurveAxis({std::nan(""), 1}, linear), ContractViolation);
  EXPECT_THROW(CurveAxis({0, 1}, logarithmic), ContractViolation);
  EXPECT_NO_THROW(CurveAxis({-1, 1}, linear));
}

TEST(AxisRanges, CoverTheValuesAndAreNeverEmpty) {
  const AxisRange some = range_of({3, -1, 2}, linear);
  EXPECT_EQ(some.low, -1.0);
  EXPECT_EQ(some.high, 3.0);
  for (const double one : {0.0, 5.0, -5.0}) {
    const AxisRange room = range_of({one, one}, linear);
    EXPECT_LT(room.low, one);
    EXPECT_GT(room.high, one);
  }
  const AxisRange positive = range_of({5}, logarithmic);
  EXPECT_EQ(positive.low * positive.high, 25.0);
  EXPECT_THROW(range_of({}, linear), ContractViolation);
}

TEST(AxisRanges, AreRoundedToTicksThatStandAtBothEnds) {
  for (const AxisRange range : {AxisRange{0.13, 9.7}, AxisRange{-3.2, 41}, AxisRange{1e5, 1.1e5}}) {
    const AxisRange wide = rounded_outwards(range, linear);
    EXPECT_LE(wide.low, range.low);
    EXPECT_GE(wide.high, range.high);
    EXPECT_LT(wide.high - wide.low, 1.8 * (range.high - range.low));
    const auto ticks = CurveAxis(wide, linear).ticks();
    EXPECT_NEAR(ticks.front().value, wide.low, 1e-9 * (wide.high - wide.low));
    EXPECT_NEAR(ticks.back().value, wide.high, 1e-9 * (wide.high - wide.low));
  }
  const AxisRange whole = rounded_outwards({0, 50}, linear);
  EXPECT_EQ(whole.low, 0.0);
  EXPECT_EQ(whole.high, 50.0);
  const AxisRange decades = rounded_outwards({1, 100}, logarithmic);
  EXPECT_LT(decades.low, 1.0);
  EXPECT_GT(decades.low, 0.5);
}

}  // namespace
}  // namespace phytobench
