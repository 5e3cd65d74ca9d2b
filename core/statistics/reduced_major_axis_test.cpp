// SPDX-License-Identifier: MIT
#include "core/statistics/reduced_major_axis.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/power_law.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

// Means 2 and 4, sums of squares 10 and 30, of products 17, residuals 0.4 -0.3 0 -0.7 0.6.
const Values line_x{0, 1, 2, 3, 4}, line_y{1, 2, 4, 5, 8};

TEST(StraightLines, AreThoseByHand) {
  const auto least = least_squares_line(line_x, line_y), axis = reduced_major_axis(line_x, line_y);
  ASSERT_TRUE(least && axis);
  EXPECT_NEAR(least->slope, 1.7, 1e-15);
  EXPECT_NEAR(least->intercept, 0.6, 1e-15);
  EXPECT_NEAR(axis->slope, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(axis->intercept, 4.0 - 2.0 * std::sqrt(3.0), 1e-15);
  for (const StraightLine& line : {*least, *axis}) {
    EXPECT_NEAR(line.slope_error, std::sqrt(1.1 / 3.0 / 10.0), 1e-15);
    EXPECT_NEAR(line.r_squared, 289.0 / 300.0, 1e-15);
    EXPECT_EQ(line.points, 5u);
  }
}

TEST(StraightLines, OfPointsOnALineAreThatLine) {
  for (const double slope : {-1.5, 0.25, 40.0}) {
    Values x, y;
    for (int i = 0; i < 9; ++i) {
      x.push_back(1e3 + i * i);
      y.push_back(7.0 + slope * x.back());
    }
    for (const auto& line : {least_squares_line(x, y), reduced_major_axis(x, y)}) {
      ASSERT_TRUE(line);
      EXPECT_NEAR(line->slope, slope, 1e-12 * std::abs(slope));
      EXPECT_NEAR(line->intercept, 7.0, 1e-8);
      EXPECT_NEAR(line->r_squared, 1.0, 1e-14);
      EXPECT_NEAR(line->slope_error, 0.0, 1e-12);
    }
  }
}

TEST(StraightLines, FarFromZeroKeepTheirDigits) {
  Values x = line_x, y = line_y;
  for (double& value : x) value += 1e9;
  for (double& value : y) value -= 1e9;
  EXPECT_NEAR(reduced_major_axis(x, y)->slope, std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(least_squares_line(x, y)->r_squared, 289.0 / 300.0, 1e-14);
}

/// Normal numbers by Box and Muller's transform.
Values normal_values(std::size_t count, std::uint64_t number) {
  CounterStream stream(11, number);
  Values values;
  while (values.size() < count) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - stream.next_unit()));
    values.push_back(radius * std::cos(2.0 * std::numbers::pi * stream.next_unit()));
  }
  return values;
}

struct Cloud {
  Values x, y;
};

/// Standard deviations 1 and 1.5, correlation -0.8.
Cloud cloud(std::size_t count, std::uint64_t number) {
  const Values first = normal_values(count, 2 * number),
               second = normal_values(count, 2 * number + 1);
  Cloud points;
  for (std::size_t i = 0; i < count; ++i) {
    points.x.push_back(first[i]);
    points.y.push_back(1.5 * (-0.8 * first[i] + 0.6 * second[i]));
  }
  return points;
}

TEST(ReducedMajorAxisLaw, SwappedAxesInvertItAndMeansStayOnIt) {
  const auto [x, y] = cloud(40, 0);
  const auto line = reduced_major_axis(x, y), swapped = reduced_major_axis(y, x);
  ASSERT_TRUE(line && swapped);
  EXPECT_NEAR(line->slope * swapped->slope, 1.0, 1e-14);
  EXPECT_NEAR(line->r_squared, swapped->r_squared, 1e-14);
  EXPECT_NEAR(line->intercept + line->slope * swapped->intercept, 0.0, 1e-13);
}

TEST(ReducedMajorAxisLaw, LeastSquaresHaveItsSlopeTimesTheCorrelation) {
  const auto [x, y] = cloud(40, 1);
  const auto axis = reduced_major_axis(x, y), least = least_squares_line(x, y);
  ASSERT_TRUE(axis && least);
  EXPECT_NEAR(least->slope, axis->slope * std::sqrt(axis->r_squared), 1e-13);
}

TEST(ReducedMajorAxisLaw, UnitsOfEitherAxisScaleTheSlopeAndItsError) {
  auto [x, y] = cloud(40, 2);
  const auto line = reduced_major_axis(x, y);
  for (double& value : x) value *= 4.0;
  for (double& value : y) value = 32.0 * value + 5.0;
  const auto scaled = reduced_major_axis(x, y);
  ASSERT_TRUE(line && scaled);
  EXPECT_NEAR(scaled->slope, 8.0 * line->slope, 1e-13);
  EXPECT_NEAR(scaled->slope_error, 8.0 * line->slope_error, 1e-13);
  EXPECT_NEAR(scaled->intercept, 32.0 * line->intercept + 5.0, 1e-12);
}

TEST(ReducedMajorAxisLaw, FindsTheRatioOfDeviationsAndKnowsHowWell) {
  RunningMoments slopes, errors, least;
  for (std::uint64_t number = 10; number < 410; ++number) {
    const auto [x, y] = cloud(50, number);
    const auto line = reduced_major_axis(x, y);
    ASSERT_TRUE(line);
    slopes.add(line->slope);
    errors.add(line->slope_error);
    least.add(least_squares_line(x, y)->slope);
  }
  EXPECT_NEAR(slopes.mean(), -1.5, 4.0 * slopes.standard_error() + 0.01) << "0.01: bias at n = 50";
  EXPECT_NEAR(least.mean(), -1.2, 4.0 * least.standard_error());
  // A deviation of 400 values is known to 3.5 per cent.
  EXPECT_NEAR(errors.mean() / slopes.deviation(), 1.0, 0.15);
}

TEST(StraightLines, OfLogarithmsAgreeWithThePowerLawFit) {
  const Values x{1, 2, 4, 8, 16}, y{2, 4, 16, 32, 256};
  Values log_x, log_y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    log_x.push_back(std::log(x[i]));
    log_y.push_back(std::log(y[i]));
  }
  const auto law = fit_power_law(x, y);
  const auto line = least_squares_line(log_x, log_y);
  ASSERT_TRUE(law && line);
  EXPECT_NEAR(line->slope, law->exponent.value, 1e-14);
  constexpr double qt_0975_3 = 3.18244630528371;
  EXPECT_NEAR(qt_0975_3 * line->slope_error, law->exponent.high - law->exponent.value, 1e-12);
}

TEST(StraightLines, NeedThreePointsAndSpreadOnBothAxes) {
  EXPECT_FALSE(reduced_major_axis({}, {}));
  EXPECT_FALSE(least_squares_line(Values{1, 2}, Values{1, 4}));
  EXPECT_FALSE(reduced_major_axis(Values(5, 0.1), line_y));
  EXPECT_FALSE(least_squares_line(line_x, Values(5, 0.1)));
  EXPECT_FALSE(reduced_major_axis(Values{-1, 0, 1}, Values{1, 0, 1})) << "no direction";
  EXPECT_TRUE(least_squares_line(Values{-1, 0, 1}, Values{1, 0, 1}));
}

TEST(StraightLines, RefuseUnpairedAndEndlessValues) {
  EXPECT_THROW(reduced_major_axis(line_x, Values{1, 2}), ContractViolation);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(least_squares_line(line_x, Values{1, 2, bad, 4, 5}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
