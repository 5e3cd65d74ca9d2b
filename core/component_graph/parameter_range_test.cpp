// SPDX-License-Identifier: MIT
#include "core/component_graph/parameter_range.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/component_graph/component_values.hpp"
#include "core/component_graph/parameter_expression.hpp"
#include "core/component_graph/test_components.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

InstancePlace place(std::uint32_t i, std::uint32_t n, std::uint64_t identity = 1) {
  InstancePlace place;
  place.number = {i, n};
  place.identity = identity;
  return place;
}

ParameterRange range(double first, double last, const std::string& function = "") {
  ParameterRange range = ParameterRange::of(first);
  range.frames[0].value.last = last;
  if (!function.empty()) range.function = parse_parameter_function(function, "p");
  return range;
}

/// The formula as printed: v_i = i (v_1 - v_0) / (n - 1).
double printed(double v0, double v1, std::uint32_t i, std::uint32_t n) {
  return i * (v1 - v0) / (n - 1.0);
}

TEST(ParameterRange, FiveSiblingsFromTenToTwenty) {
  const ParameterRange ten_to_twenty = range(10.0, 20.0);
  const double expected[] = {10.0, 12.5, 15.0, 17.5, 20.0};
  for (std::uint32_t i = 1; i <= 5; ++i)
    EXPECT_EQ(ten_to_twenty.resolved(place(i, 5)), expected[i - 1]);
  EXPECT_EQ(ten_to_twenty.resolved(place(1, 1)), 10.0);
}

TEST(ParameterRange, ThePrintedFormulaLeavesTheRange) {
  EXPECT_EQ(printed(10.0, 20.0, 0, 5), 0.0);
  EXPECT_EQ(printed(10.0, 20.0, 4, 5), 10.0);  // counted from 0, only the last is in the range
  EXPECT_EQ(printed(10.0, 20.0, 1, 5), 2.5);
  EXPECT_EQ(printed(10.0, 20.0, 5, 5), 12.5);  // counted from 1, it ends at a quarter of it
  EXPECT_FALSE(std::isfinite(printed(10.0, 20.0, 1, 1)));
}

TEST(ParameterRangeLaw, EndsAreExactAndStepsEqual) {
  for (std::uint32_t n = 2; n <= 50; ++n) {
    const ParameterRange odd = range(0.1, -1.0 / 3.0);
    EXPECT_EQ(odd.resolved(place(1, n)), 0.1);
    EXPECT_EQ(odd.resolved(place(n, n)), -1.0 / 3.0);
    double sum = 0.0;
    for (std::uint32_t i = 1; i <= n; ++i) {
      sum += odd.resolved(place(i, n));
      if (i > 1) {
        EXPECT_NEAR(odd.resolved(place(i, n)) - odd.resolved(place(i - 1, n)),
                    (-1.0 / 3.0 - 0.1) / (n - 1.0), 1e-15);
      }
    }
    EXPECT_NEAR(sum / n, 0.5 * (0.1 - 1.0 / 3.0), 1e-14);
  }
}

TEST(ParameterRange, KeyFramesAreLinearAndClamped) {
  ParameterRange growing;
  growing.frames = {{0.0, {1.0, 1.0}}, {10.0, {3.0, 5.0}}, {20.0, {3.0, 3.0}}};
  EXPECT_EQ(growing.at_time(-5.0), (NumberSpan{1.0, 1.0}));
  EXPECT_EQ(growing.at_time(0.0), (NumberSpan{1.0, 1.0}));
  EXPECT_EQ(growing.at_time(5.0), (NumberSpan{2.0, 3.0}));
  EXPECT_EQ(growing.at_time(10.0), (NumberSpan{3.0, 5.0}));
  EXPECT_EQ(growing.at_time(15.0), (NumberSpan{3.0, 4.0}));
  EXPECT_EQ(growing.at_time(1e9), (NumberSpan{3.0, 3.0}));
}

TEST(ParameterRange, AFunctionSeesTheInterpolatedValueAndThePlace) {
  InstancePlace where = place(2, 3);
  where.depth = 4;
  where.time = 0.5;
  EXPECT_EQ(range(10.0, 20.0, "value").resolved(where), 15.0);
  EXPECT_EQ(range(10.0, 20.0, "value * 2 + i + 10 * n + 100 * depth + t").resolved(where),
            30.0 + 2.0 + 30.0 + 400.0 + 0.5);
}

TEST(ParameterRange, RandomNumbersBelongToInstanceAndParameter) {
  ParameterRange jittered = range(1.0, 1.0, "random(2, 3)");
  std::vector<double> drawn;
  for (std::uint64_t identity = 1; identity <= 1000; ++identity)
    drawn.push_back(jittered.resolved(place(1, 1, identity)));
  double sum = 0.0;
  for (const double value : drawn) {
    EXPECT_GE(value, 2.0);
    EXPECT_LT(value, 3.0);
    sum += value;
  }
  EXPECT_NEAR(sum / 1000.0, 2.5, 0.05);  // five standard deviations
  EXPECT_EQ(jittered.resolved(place(1, 1, 7)), drawn[6]);
  EXPECT_EQ(jittered.resolved(place(3, 9, 7)), drawn[6]);
  InstancePlace reseeded = place(1, 1, 7);
  reseeded.seed = 1;
  EXPECT_NE(jittered.resolved(reseeded), drawn[6]);
  jittered.random_stream = 1;
  EXPECT_NE(jittered.resolved(place(1, 1, 7)), drawn[6]);
}

TEST(ParameterRange, TwoCallsOfRandomDiffer) {
  EXPECT_NE(range(0.0, 0.0, "random(0, 1) - random(0, 1)").resolved(place(1, 1)), 0.0);
}

TEST(ParameterRange, KnowsWhetherSiblingsMayDiffer) {
  EXPECT_FALSE(range(1.0, 1.0).varies());
  EXPECT_TRUE(range(1.0, 2.0).varies());
  EXPECT_FALSE(range(1.0, 1.0, "value * t + 3").varies());
  EXPECT_TRUE(range(1.0, 2.0, "value * t").varies());
  EXPECT_FALSE(range(1.0, 2.0, "t").varies());
  for (const std::string text : {"i", "n", "depth", "random(0, 1)"})
    EXPECT_TRUE(range(1.0, 1.0, text).varies()) << text;
}

TEST(ParameterRange, WholeNumbersAreRoundedToTheNearest) {
  const std::vector<ComponentSetting> settings{range(3.0, 6.0)};
  const auto count = [&](std::uint32_t i) {
    return ComponentValues(test_components::count_key, settings, place(i, 5)).count(0);
  };
  EXPECT_EQ(count(1), 3u);  // 3, 3.75, 4.5, 5.25, 6
  EXPECT_EQ(count(2), 4u);
  EXPECT_EQ(count(3), 5u);
  EXPECT_EQ(count(4), 5u);
  EXPECT_EQ(count(5), 6u);
  const auto made = [](double value, const std::string& function) {
    const std::vector<ComponentSetting> setting{range(value, value, function)};
    return ComponentValues(test_components::count_key, setting, place(1, 1)).count(0);
  };
  EXPECT_EQ(made(2.0, "value * 1.2"), 2u);
  EXPECT_EQ(made(2.0, "value * 1.25"), 3u);  // halves up
  EXPECT_EQ(made(2.0, "value * 1.75"), 4u);
  EXPECT_EQ(made(2.0, "-0.2 * value"), 0u);
  EXPECT_THROW(made(2.0, "-0.3 * value"), InputError);  // -1 is below the least
}

TEST(ParameterRange, WhatAFunctionGivesIsHeldAgainstTheRange) {
  for (const std::string text : {"1e20", "-1", "log(i - 2)", "1 / (i - 1)"}) {
    const std::vector<ComponentSetting> settings{range(1.0, 1.0, text)};
    const ComponentValues values(test_components::count_key, settings, place(1, 3));
    EXPECT_THROW(values.count(0), InputError) << text;
  }
}

std::string function_refusal(const std::string& text) {
  try {
    parse_parameter_function(text, "w.toml:3: a.b");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParameterFunction, WrongOnesAreRefusedWithTheColumn) {
  EXPECT_EQ(function_refusal("value * 2"), "accepted");
  EXPECT_EQ(function_refusal("valu * 2"),
            "w.toml:3: a.b: in its function at column 1: unknown name 'valu'; did you mean "
            "'value'?; known: value, i, n, depth, t");
  EXPECT_NE(function_refusal("2 * x").find("column 5: unknown name 'x'"), std::string::npos);
  EXPECT_NE(function_refusal("value )").find("column 7"), std::string::npos);
  EXPECT_NE(function_refusal("").find("is empty"), std::string::npos);
  EXPECT_NE(function_refusal("  ").find("is empty"), std::string::npos);
  EXPECT_NE(function_refusal("value * \xc3\xa4").find("has no place"), std::string::npos);
  EXPECT_NE(function_refusal("value\n+ 1").find("has no place"), std::string::npos);
  EXPECT_NE(function_refusal(std::string(3000, '1')).find("longer than"), std::string::npos);
  for (const std::string text : {"value *", "sin(1, 2)", "(value", "random(1)", "1 / 0", "sin",
                                 "frobnicate(value)", "1 2", "value value"})
    EXPECT_NE(function_refusal(text).find("w.toml:3: a.b: in its function at column"),
              std::string::npos)
        << text << ": " << function_refusal(text);
}

TEST(VectorFieldTest, SeesThePlaceAndTheTime) {
  const VectorField field = parse_vector_field({"x + t", "2 * y", "-z"}, "w.photo");
  EXPECT_EQ(field.at({1.0, 2.0, 3.0}, 10.0), (Vector3{11.0, 4.0, -3.0}));
  EXPECT_EQ(direction_of(field, {0.0, 1.0, 0.0}, 0.0), (Vector3{0.0, 1.0, 0.0}));
  EXPECT_EQ(direction_of(field, {0.0, 0.0, 0.0}, 0.0), (Vector3{}));
  EXPECT_EQ(direction_of(VectorField(Vector3{0.0, -1e300, 0.0}), {}, 0.0),
            (Vector3{0.0, -1.0, 0.0}));
  EXPECT_THROW(parse_vector_field({"1", "random(0, 1)", "1"}, "w.photo"), InputError);
  EXPECT_THROW(parse_vector_field({"1 / x", "0", "0"}, "w.photo").at({}, 0.0), InputError);
}

}  // namespace
}  // namespace phytobench
