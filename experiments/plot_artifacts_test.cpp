// SPDX-License-Identifier: MIT
#include "experiments/plot_artifacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/record/plot_files.hpp"

namespace phytobench {
namespace {

PlotData of_curve(PlotCurve curve) {
  return {.title = "t", .description = "d", .panels = {{.curves = {std::move(curve)}}}};
}

/// The only curve of a plot, as its artifacts hold it.
PlotCurve left_behind(const PlotData& plot) {
  ExperimentContext context("paper/experiment", Tier::smoke, 1, 1);
  add_plot(context, "figure-1", plot);
  EXPECT_EQ(context.artifacts().size(), 2u);
  EXPECT_EQ(context.artifacts()[0].name, "figure-1.plot.json");
  EXPECT_EQ(context.artifacts()[1].name, "figure-1.csv");
  EXPECT_TRUE(context.records().empty());
  return parse_plot(context.artifacts()[0].content, "json", context.artifacts()[1].content, "csv")
      .panels.at(0)
      .curves.at(0);
}

/// Two turns of a sine, sampled so often.
PlotCurve sine(int count) {
  PlotCurve curve{.name = "sine", .x = {}, .y = {}};
  for (int i = 0; i <= count; ++i) {
    curve.x.push_back(4.0 * i / count);
    curve.y.push_back(std::sin(3.141592653589793 * curve.x.back()));
  }
  return curve;
}

/// y of the line through a curve's points.
double at(const PlotCurve& curve, double x) {
  const auto next = static_cast<std::size_t>(
      std::upper_bound(curve.x.begin() + 1, curve.x.end() - 1, x) - curve.x.begin());
  const double share = (x - curve.x[next - 1]) / (curve.x[next] - curve.x[next - 1]);
  return curve.y[next - 1] + share * (curve.y[next] - curve.y[next - 1]);
}

TEST(AddPlot, KeepsEveryPointOfAShortCurve) {
  EXPECT_EQ(left_behind(of_curve(sine(149))).x.size(), 150u);
}

TEST(AddPlotLaw, LeavesOutOnlyWhatNobodySees) {
  const PlotCurve all = sine(20000), some = left_behind(of_curve(all));
  EXPECT_LT(some.x.size(), 400u);
  EXPECT_EQ(some.x.front(), 0.0);
  EXPECT_EQ(some.x.back(), 4.0);
  for (std::size_t i = 0; i < all.x.size(); ++i)
    ASSERT_NEAR(at(some, all.x[i]), all.y[i], 2.0 * 8.0 / 4000.0) << all.x[i];  // steepest: 8 to 1
}

TEST(AddPlot, KeepsJumpsAndBreaks) {
  PlotCurve curve = sine(1000);
  const double no_value = std::numeric_limits<double>::quiet_NaN();
  curve.y[500] = no_value;
  curve.y[700] = 1.0;
  curve.y[701] = -1.0;
  const PlotCurve some = left_behind(of_curve(curve));
  const auto is_kept = [&](std::size_t i) {
    return std::find(some.x.begin(), some.x.end(), curve.x[i]) != some.x.end();
  };
  for (const std::size_t i : {499u, 500u, 501u, 700u, 701u}) EXPECT_TRUE(is_kept(i)) << i;
  EXPECT_EQ(std::count_if(some.y.begin(), some.y.end(), [](double y) { return std::isnan(y); }), 1);
}

TEST(AddPlot, LeavesOnePointInEveryCell) {
  PlotCurve cloud{.name = "cloud", .x = {}, .y = {}, .style = PlotStyle::points};
  constexpr double heights[] = {0.0, 0.351, 1.0};
  for (int i = 0; i < 10000; ++i) {
    cloud.x.push_back(i % 10);
    cloud.y.push_back(heights[i % 3] + (i % 3 == 1 ? 1e-9 * i : 0.0));
  }
  EXPECT_EQ(left_behind(of_curve(cloud)).x.size(), 30u);
}

TEST(AddPlot, NeverThinsWhatWasMeasuredPointByPoint) {
  PlotCurve marked = sine(400);
  for (const PlotStyle style : {PlotStyle::marked, PlotStyle::steps}) {
    marked.style = style;
    EXPECT_EQ(left_behind(of_curve(marked)).x.size(), 401u);
  }
  marked.style = PlotStyle::solid;
  marked.low = marked.high = marked.y;
  EXPECT_EQ(left_behind(of_curve(marked)).x.size(), 401u);
}

TEST(AddPlotContract, RefusesUnsoundAndHugePlots) {
  ExperimentContext context("paper/experiment", Tier::smoke, 1, 1);
  EXPECT_THROW(add_plot(context, "p", of_curve({.name = "empty", .x = {}, .y = {}})),
               ContractViolation);
  PlotCurve noise{.name = "noise", .x = {}, .y = {}};
  for (int i = 0; i < 6000; ++i) {
    noise.x.push_back(i);
    noise.y.push_back(i % 2);
  }
  EXPECT_THROW(add_plot(context, "p", of_curve(noise)), ContractViolation);
  EXPECT_TRUE(context.artifacts().empty());
}

}  // namespace
}  // namespace phytobench
