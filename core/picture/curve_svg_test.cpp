// SPDX-License-Identifier: MIT
#include "core/picture/curve_svg.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// What stands in the path of the first curve.
std::string curve_path(const std::string& svg) {
  const std::string key = " d=\"";
  const std::size_t from = svg.find(key, svg.find("overflow=")) + key.size();
  return svg.substr(from, svg.find('"', from) - from);
}

CurvePanel panel_of(std::vector<double> x, std::vector<double> y) {
  return {.curves = {{.name = "one", .x = std::move(x), .y = std::move(y)}}};
}

TEST(CurveSvg, DrawsFromTheLowerLeftToTheUpperRightCorner) {
  EXPECT_EQ(curve_path(curve_svg({panel_of({0, 1, 2}, {0, 5, 10})}, "")), "M0.0 220.0L290.0 0.0");
  EXPECT_EQ(curve_path(curve_svg({panel_of({0, 1, 2}, {0, 7.5, 10})}, "")),
            "M0.0 220.0L145.0 55.0L290.0 0.0");
}

TEST(CurveSvg, LogarithmicAxesMakePowersStraight) {
  CurvePanel panel = panel_of({1, 10, 100}, {100, 1, 0.01});
  panel.x_scale = panel.y_scale = AxisScale::logarithmic;
  panel.y_range = AxisRange{0.01, 100};
  EXPECT_EQ(curve_path(curve_svg({panel}, "")), "M0.0 0.0L290.0 220.0");
}

TEST(CurveSvg, GapsBreakALineAndLonePointsShow) {
  const double gap = std::nan("");
  CurvePanel panel = panel_of({0, 1, 2, 3, 4}, {0, 10, gap, 5, gap});
  EXPECT_EQ(curve_path(curve_svg({panel}, "")), "M0.0 220.0L96.7 0.0M290.0 110.0h0");
}

TEST(CurveSvg, PointsStandAlone) {
  CurvePanel panel = panel_of({0, 2}, {0, 10});
  panel.curves[0].style = CurveStyle::points;
  EXPECT_EQ(curve_path(curve_svg({panel}, "")), "M0.0 220.0h0M290.0 0.0h0");
}

TEST(CurveSvg, WhatLiesOutsideAGivenRangeIsCutOff) {
  CurvePanel panel = panel_of({0, 1, 2}, {0, 5, 10});
  EXPECT_EQ(count_of(curve_svg({panel}, ""), "overflow=\"visible\""), 1u);
  panel.y_range = AxisRange{0, 4};
  EXPECT_EQ(count_of(curve_svg({panel}, ""), "overflow=\"hidden\""), 1u);
}

TEST(CurveSvg, OneNameHasOneColourInAllPanelsAndOneLegendEntryPerStyle) {
  CurvePanel first = panel_of({0, 1}, {0, 1}), second = panel_of({0, 1}, {1, 2});
  first.curves.push_back({.name = "two", .x = {0, 1}, .y = {2, 2}});
  second.curves.push_back({.name = "two", .x = {0, 1}, .y = {2, 2}, .style = CurveStyle::dashed});
  second.curves.push_back({.name = "", .x = {0, 1}, .y = {2, 2}});
  const std::string svg = curve_svg({first, second}, "title");
  EXPECT_EQ(count_of(svg, ">one</text>"), 1u);
  EXPECT_EQ(count_of(svg, ">two</text>"), 2u);
  EXPECT_EQ(count_of(svg, "stroke=\"#247be0\""), 3u) << "twice drawn, once in the legend";
  EXPECT_EQ(count_of(svg, "stroke=\"#ca5b0b\""), 4u);
  EXPECT_EQ(count_of(svg, "stroke-dasharray"), 2u);
}

TEST(CurveSvg, ColoursMayBeChosen) {
  CurvePanel panel = panel_of({0, 1}, {0, 1});
  panel.curves[0].colour = 4;
  EXPECT_EQ(count_of(curve_svg({panel}, ""), "stroke=\"#d84a46\""), 2u);
  panel.curves[0].colour = curve_colours;
  EXPECT_THROW(curve_svg({panel}, ""), ContractViolation);
}

TEST(CurveSvg, TextsAreWrittenOut) {
  CurvePanel panel = panel_of({0, 1}, {0, 1});
  panel.curves[0].name = "a < b & \"c\"";
  panel.caption = "<caption>";
  const std::string svg = curve_svg({panel}, "<title>");
  EXPECT_EQ(count_of(svg, "a &lt; b &amp; &quot;c&quot;"), 1u);
  EXPECT_EQ(count_of(svg, "&lt;caption&gt;"), 1u);
  EXPECT_EQ(count_of(svg, "&lt;title&gt;"), 2u);
}

TEST(CurveSvg, LongCurvesStaySmallAndKeepTheirEndsAndForm) {
  std::vector<double> x, y;
  for (int i = 0; i <= 100'000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(1e-4 * i));
  }
  const std::string svg = curve_svg({panel_of(x, y)}, "");
  EXPECT_LT(svg.size(), 5'000u);
  const std::string path = curve_path(svg);
  EXPECT_EQ(path.substr(0, 2), "M0");
  EXPECT_NE(path.find("L290.0 "), std::string::npos);
  EXPECT_GT(count_of(path, "L"), 30u);
}

TEST(CurveSvg, GivesTheSameBytesAgain) {
  const CurvePanel panel = panel_of({0, 1, 2}, {0.1, 0.5, 0.3});
  EXPECT_EQ(curve_svg({panel, panel}, "a"), curve_svg({panel, panel}, "a"));
}

TEST(CurveSvg, RefusesWhatCannotBeDrawn) {
  const double infinity = std::numeric_limits<double>::infinity(), none = std::nan("");
  const auto drawn = [](const CurvePanel& panel) { return curve_svg({panel}, ""); };
  EXPECT_THROW(curve_svg({}, ""), ContractViolation);
  EXPECT_THROW(drawn({}), ContractViolation);
  EXPECT_THROW(drawn(panel_of({1, 2}, {none, none})), ContractViolation);
  EXPECT_THROW(drawn(panel_of({1, 2}, {1})), ContractViolation);
  EXPECT_THROW(drawn(panel_of({1, 2}, {1, infinity})), ContractViolation);
  EXPECT_THROW(drawn(panel_of({1, none}, {1, 2})), ContractViolation);
  CurvePanel panel = panel_of({0, 1}, {1, 2});
  EXPECT_NO_THROW(drawn(panel));
  panel.x_scale = AxisScale::logarithmic;
  EXPECT_THROW(drawn(panel), ContractViolation);
}

}  // namespace
}  // namespace phytobench
