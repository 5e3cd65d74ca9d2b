// SPDX-License-Identifier: MIT
#include "core/record/plot_files.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/record/plot_points.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

PlotData two_panels() {
  return {.title = "A title",
          .description = "What is seen: a \"rise\" & a fall",
          .panels = {{.curves = {{.name = "plant 1, a = 2",
                                  .x = {0.0, 0.1, 0.2, 0.3},
                                  .y = {1.0, -2.5, no_value, 1e-7},
                                  .style = PlotStyle::dashed,
                                  .colour = 3},
                                 {.name = "a \"quoted\" name", .x = {1e6}, .y = {0.0}}},
                      .caption = "a) left",
                      .x_label = "time, years",
                      .y_label = "size",
                      .x_range = AxisRange{0.0, 10.0}},
                     {.curves = {{.name = "mean",
                                  .x = {1.0, 2.0},
                                  .y = {3.0, 4.0},
                                  .style = PlotStyle::marked,
                                  .low = {2.5, 3.5},
                                  .high = {3.5, 4.5}}},
                      .log_x = true,
                      .log_y = true}}};
}

PlotData lone() {
  return {.title = "t",
          .description = "d",
          .panels = {{.curves = {{.name = "s", .x = {1.0}, .y = {2.0}}}}}};
}

PlotData read_back(const PlotData& plot) {
  return parse_plot(plot_json(plot), "p.plot.json", plot_csv(plot), "p.csv");
}

/// What the reader says of texts, "" if it takes them.
std::string refusal(const std::string& json, const std::string& csv) {
  try {
    parse_plot(json, "p.plot.json", csv, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(PlotFilesLaw, ReadingGivesBackWhatWasWritten) {
  const PlotData plot = two_panels(), read = read_back(plot);
  EXPECT_EQ(plot_json(read), plot_json(plot));
  EXPECT_EQ(plot_csv(read), plot_csv(plot));
  const PlotCurve& curve = read.panels[0].curves[0];
  EXPECT_EQ(curve.name, "plant 1, a = 2");
  EXPECT_EQ(curve.x, (std::vector{0.0, 0.1, 0.2, 0.3}));
  EXPECT_TRUE(std::isnan(curve.y[2]));
  EXPECT_EQ(curve.y[3], 1e-7);
  EXPECT_EQ(curve.style, PlotStyle::dashed);
  EXPECT_EQ(curve.colour, 3u);
  EXPECT_TRUE(curve.low.empty());
  EXPECT_EQ(read.panels[1].curves[0].high, (std::vector{3.5, 4.5}));
  EXPECT_TRUE(read.panels[1].log_x && read.panels[1].log_y && !read.panels[0].log_y);
  EXPECT_EQ(read.panels[0].x_range->high, 10.0);
  EXPECT_FALSE(read.panels[0].y_range);
}

TEST(PlotFiles, HaveSixDigitsInTheirShortestForm) {
  PlotData plot = lone();
  plot.panels[0].curves[0] = {
      .name = "s", .x = {0.1 + 0.2, 1.0 / 3.0, -0.0}, .y = {1e-20, 40, 2e9}};
  EXPECT_EQ(plot_csv(plot), "series,x,y\ns,0.3,1e-20\ns,0.333333,40\ns,0,2000000000\n");
}

TEST(PlotFiles, NamePanelsAndBarsWhereThereAreSome) {
  EXPECT_THAT(plot_csv(two_panels()), StartsWith("panel,series,x,y,low,high\n"
                                                 "1,\"plant 1, a = 2\",0,1,,\n"));
  EXPECT_THAT(plot_csv(two_panels()), HasSubstr("\n1,\"a \"\"quoted\"\" name\",1000000,0,,\n"));
  EXPECT_THAT(plot_csv(two_panels()), HasSubstr("\n2,mean,1,3,2.5,3.5\n"));
}

TEST(PlotFiles, AreRefusedWithLineOrKeyWhereForeign) {
  const std::string json = plot_json(lone()), csv = plot_csv(lone());
  EXPECT_EQ(refusal(json, csv), "");
  EXPECT_THAT(refusal("{\n\n x", csv), StartsWith("p.plot.json:3: is no JSON"));
  EXPECT_THAT(refusal("[]", csv), HasSubstr("'schema'"));
  EXPECT_THAT(refusal(replaced(json, "plot-1", "plot-9"), csv), HasSubstr("'schema'"));
  EXPECT_THAT(refusal(replaced(json, "\"title\"", "\"name\""), csv),
              StartsWith("p.plot.json: has a key 'name'"));
  EXPECT_THAT(refusal(replaced(json, "\"caption\": \"\",", ""), csv),
              StartsWith("p.plot.json: panels[0] lacks the key 'caption'"));
  EXPECT_THAT(refusal(replaced(json, "\"solid\"", "\"bold\""), csv),
              StartsWith("p.plot.json: panels[0].series[0].style is no style"));
  EXPECT_THAT(refusal(replaced(json, "false", "0"), csv),
              StartsWith("p.plot.json: panels[0].x.log is neither"));
  EXPECT_THAT(refusal(replaced(json, "false", "false, \"range\": [2, 1]"), csv),
              StartsWith("p.plot.json: panels[0].x.range is no range"));
}

TEST(PlotFiles, AreRefusedForPointsThatDoNotFit) {
  const std::string json = plot_json(lone()), csv = plot_csv(lone());
  EXPECT_THAT(refusal(json, ""), StartsWith("p.csv:1: is empty"));
  EXPECT_THAT(refusal(json, "x,y\n"), StartsWith("p.csv:1: the header is not series,x,y"));
  EXPECT_THAT(refusal(json, "panel,series,x,y\n"), StartsWith("p.csv:1: the header"));
  EXPECT_THAT(refusal(json, csv + "s,1\n"), StartsWith("p.csv:3: 2 fields instead of 3"));
  EXPECT_THAT(refusal(json, csv + "s,1,2,3\n"), StartsWith("p.csv:3: 4 fields"));
  EXPECT_THAT(refusal(json, csv + "r,1,2\n"), StartsWith("p.csv:3: no series 'r'"));
  EXPECT_THAT(refusal(json, csv + "s,one,2\n"), StartsWith("p.csv:3: 'one' is no finite number"));
  EXPECT_THAT(refusal(json, csv + "s,1,inf\n"), StartsWith("p.csv:3: 'inf'"));
  EXPECT_THAT(refusal(json, csv + "s,,2\n"), StartsWith("p.csv:3: '' is no finite number"));
  EXPECT_THAT(refusal(replaced(json, "false", "true"), "series,x,y\ns,0,1\n"),
              StartsWith("p.csv:2: 0 on a logarithmic axis"));
  EXPECT_THAT(refusal(json, "series,x,y\n"), HasSubstr("the series 's' has no point"));
  EXPECT_THAT(refusal(plot_json(two_panels()), "panel,series,x,y\n3,mean,1,1\n"),
              StartsWith("p.csv:2: no panel 3"));
}

TEST(PlotFiles, MayHaveTheLineEndsOfSpreadsheets) {
  EXPECT_EQ(refusal(plot_json(lone()), "series,x,y\r\ns,1,2\r\n"), "");
  EXPECT_EQ(csv_fields("a,\"b,\"\"c\"\"\",,d"),
            (std::vector<std::string>{"a", "b,\"c\"", "", "d"}));
}

TEST(PlotProblem, IsNoneOfASoundPlotAndNamesWhatIsWrong) {
  EXPECT_EQ(plot_problem(two_panels()), "");
  const auto problem_if = [](void (*spoil)(PlotData&)) {
    PlotData plot = two_panels();
    spoil(plot);
    return plot_problem(plot);
  };
  EXPECT_NE(problem_if([](PlotData& p) { p.description = ""; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels.clear(); }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves.clear(); }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].x_range = AxisRange{1.0, 1.0}; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[1].y_range = AxisRange{0.0, 1.0}; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves[1].name = ""; }), "");
  EXPECT_THAT(problem_if([](PlotData& p) { p.panels[0].curves[1] = p.panels[0].curves[0]; }),
              HasSubstr("two series are named 'plant 1, a = 2'"));
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves[0].colour = plot_colours; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves[0].x.pop_back(); }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves[0].x[0] = no_value; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[0].curves[1].y[0] = no_value; }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[1].curves[0].low.pop_back(); }), "");
  EXPECT_NE(problem_if([](PlotData& p) { p.panels[1].curves[0].low[0] = 0.0; }), "");
}

}  // namespace
}  // namespace phytobench
