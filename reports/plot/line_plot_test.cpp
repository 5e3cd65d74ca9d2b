// SPDX-License-Identifier: MIT
#include "reports/plot/line_plot.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using Texts = std::vector<std::string>;

LinePlot small_plot() {
  LinePlot plot{.id = "small-1", .x_label = "points", .y_label = "time [s]"};
  plot.log_x = plot.log_y = true;
  plot.series = {{"grid", {1e3, 1e5, 1e7}, {1e-6, 3e-4, 0.1}, {}, {}},
                 {"scan", {1e3, 1e5}, {5e-6, 0.04}, {4e-6, 0.03}, {7e-6, 0.05}}};
  return plot;
}

/// Every match's first group, in order.
Texts found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Texts groups;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    groups.push_back((*match)[1]);
  return groups;
}

std::set<std::string> unique(const Texts& texts) {
  return {texts.begin(), texts.end()};
}

/// What closes wrongly or stays open, or "" if every tag is closed in its order.
std::string nesting_problem(const std::string& svg) {
  Texts open = {""};
  for (const std::string& tag : found(svg, "<([^>]*[^>/])>")) {
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with('/'))
      open.push_back(name);
    else if ("/" + open.back() != name)
      return name;
    else
      open.pop_back();
  }
  return open.back();
}

bool holds(const std::string& svg, const std::string& text) {
  return svg.find(text) != std::string::npos;
}

/// Tests that need gnuplot; all others run without it.
class DrawnLinePlot : public testing::Test {
 protected:
  void SetUp() override {
    if (!draw(plot_)) GTEST_SKIP() << "gnuplot (package gnuplot-nox) is not installed";
    svg_ = *draw(plot_);
  }

  LinePlot plot_ = small_plot();
  std::string svg_;
};

TEST_F(DrawnLinePlot, IsTheSameEachTime) {
  EXPECT_EQ(*draw(plot_), svg_);
}

TEST_F(DrawnLinePlot, IsOneWellFormedElementThatRefersToNothingOutside) {
  EXPECT_EQ(nesting_problem("<svg><g></svg></g>"), "/svg");
  EXPECT_EQ(nesting_problem("<svg><g a='1'/>"), "svg");
  EXPECT_EQ(nesting_problem(svg_), "");
  EXPECT_TRUE(svg_.starts_with("<svg "));
  for (const char* unwanted : {"<?", "<!", "<script", "url(", "nan"})
    EXPECT_FALSE(holds(svg_, unwanted)) << unwanted;
  EXPECT_EQ(found(svg_, "(https?:[^\"']*)"),
            (Texts{"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"}));
}

TEST_F(DrawnLinePlot, HasIdsOfItsOwnAndPointsToThem) {
  const Texts ids = found(svg_, "\\sid=[\"']([^\"']*)");
  EXPECT_EQ(unique(ids).size(), ids.size());
  EXPECT_THAT(ids, testing::Each(testing::StartsWith("small-1-")));
  EXPECT_THAT(ids, testing::IsSupersetOf(unique(found(svg_, "href=[\"']#([^\"']*)"))));
  EXPECT_THAT(ids, testing::IsSupersetOf({"small-1-title", "small-1-description"}));
  EXPECT_TRUE(holds(svg_, "role=\"img\" aria-labelledby=\"small-1-title small-1-description\""));
}

TEST_F(DrawnLinePlot, TakesColourAndSizeFromThePage) {
  EXPECT_FALSE(holds(svg_, "black"));
  EXPECT_EQ(found(svg_, "<svg[^>]* (viewBox=\"0 0 [^>]*>)").size(), 1u);
  EXPECT_TRUE(found(svg_, "<svg[^>]* ((width|height)=)").empty());
}

TEST_F(DrawnLinePlot, EscapesTitleAndDescription) {
  plot_.title = "a \"b\" < 'c' & d\n> e";
  plot_.description = "</desc><script>";
  const std::string svg = *draw(plot_);
  EXPECT_TRUE(holds(svg, ">a &quot;b&quot; &lt; 'c' &amp; d &gt; e</title>"));
  EXPECT_TRUE(holds(svg, ">&lt;/desc&gt;&lt;script&gt;</desc>"));
}

TEST_F(DrawnLinePlot, TakesNamesForTextAndNeverForCommands) {
  const std::string file =
      testing::TempDir() + "phytobench_trap_of_names_" + std::to_string(::getpid());
  for (const std::string& name :
       {"' set print '" + file + "' #", "a'' ; system('touch " + file + "') #",
        "\"; system('touch " + file + "') #", "`touch " + file + "`",
        std::string("a_b^c {d} id=\"x\" href='#y' black %g @d $data0 \303\251 \\n \\")}) {
    plot_.series[0].name = plot_.series[1].name = plot_.x_label = plot_.y_label = name;
    const std::string svg = *draw(plot_);
    EXPECT_TRUE(holds(svg, "<text>" + name + "</text>")) << name;
    EXPECT_EQ(nesting_problem(svg), "") << name;
    EXPECT_FALSE(std::filesystem::exists(file)) << name;
  }
  plot_.series[1].name = "<script>\n& more";
  EXPECT_EQ(found(*draw(plot_), ">(&lt;script&?[^<]* &amp; more)<").size(),
            3u);  // key, tooltips of line and bars
}

TEST_F(DrawnLinePlot, NamesTicksPlainlyAndAtLeastTwoOfThem) {
  for (const char* tick : {"1,000", "10,000,000", "1e-6", "1e-4", "0.001", "0.1"})
    EXPECT_TRUE(holds(svg_, std::string(">") + tick + "<")) << tick;
  plot_.series = {{"a", {800, 900}, {3, 3.1}, {}, {}}};
  for (const char* tick : {"500", "1,000", "2", "5"})
    EXPECT_TRUE(holds(*draw(plot_), std::string(">") + tick + "<")) << tick;
}

/// Relative luminance and contrast of WCAG 2.1.
double luminance(int red, int green, int blue) {
  const auto linear = [](int part) {
    const double share = part / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

double contrast(double a, double b) {
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

TEST_F(DrawnLinePlot, TellsTwelveSeriesApartOnEveryPage) {
  EXPECT_NEAR(contrast(luminance(0, 0, 0), luminance(255, 255, 255)), 21.0, 1e-12);
  plot_.series.resize(12, plot_.series[0]);
  const std::string svg = *draw(plot_);
  EXPECT_EQ(unique(found(svg, "href='#small-1-gpPt([0-9]+)'[^>]* color='rgb")).size(), 12u);
  const auto colours = unique(found(svg, "<use[^>]* color='rgb\\(([^)]*)\\)'"));
  EXPECT_EQ(colours.size(), 12u);
  for (const std::string& colour : colours) {
    int red = 0, green = 0, blue = 0;
    ASSERT_EQ(std::sscanf(colour.c_str(), "%d,%d,%d", &red, &green, &blue), 3) << colour;
    for (const double page : {luminance(0xfd, 0xfd, 0xfb), luminance(0x14, 0x18, 0x14)})
      EXPECT_GE(contrast(luminance(red, green, blue), page), 4.0) << colour;
  }
}

TEST_F(DrawnLinePlot, DrawsErrorBarsWhereThereAreSome) {
  const std::size_t bars = found(svg_, "(<path stroke='rgb\\(202)").size();
  plot_.series[1].low = plot_.series[1].high = {};
  EXPECT_EQ(found(*draw(plot_), "(<path stroke='rgb\\(202)").size() + 1, bars);
}

TEST_F(DrawnLinePlot, CutsOffWhatLiesOutsideTheGivenAxes) {
  plot_.log_x = plot_.log_y = false;
  plot_.series = {{"a", {0, 100}, {0, 100}, {}, {}}};
  const auto ticks = [&] { return found(*draw(plot_), "<text>\\s*(-?[0-9.]+)</text>"); };
  EXPECT_THAT(ticks(), testing::Contains("100"));
  plot_.x_range = AxisRange{0.0, 8.0};
  plot_.y_range = AxisRange{-1.0, 1.0};
  EXPECT_THAT(ticks(), testing::IsSupersetOf({"8", "-1", "1"}));
  EXPECT_THAT(ticks(), testing::Not(testing::Contains("100")));
  plot_.log_x = true;
  plot_.series[0].x[0] = plot_.series[0].y[0] = 1.0;
  plot_.x_range = AxisRange{0.1, 10.0};
  EXPECT_THAT(ticks(), testing::IsSupersetOf({"0.1", "10"}));
}

TEST_F(DrawnLinePlot, DrawsEachStyleInItsWay) {
  plot_.series = {{"a", {1e3, 1e5}, {1e-6, 1e-2}, {}, {}}};
  const auto drawn = [&](PlotStyle style) {
    plot_.series[0].style = style;
    return *draw(plot_);
  };
  const auto marks = [](const std::string& svg) {
    return found(svg, "<use xlink:href='#small-1-(gpPt[0-9]+)' transform").size();
  };
  EXPECT_EQ(marks(drawn(PlotStyle::marked)), 3u);  // one in the key
  EXPECT_EQ(marks(drawn(PlotStyle::points)), 3u);
  EXPECT_EQ(marks(drawn(PlotStyle::solid)), 0u);
  EXPECT_FALSE(holds(drawn(PlotStyle::points), "stroke-dasharray"));
  EXPECT_FALSE(holds(drawn(PlotStyle::solid), "stroke-dasharray"));
  EXPECT_TRUE(holds(drawn(PlotStyle::dashed), "stroke-dasharray"));
  EXPECT_NE(drawn(PlotStyle::dashed), drawn(PlotStyle::dotted));
  // A step more than a line: along, then up.
  const auto corners = [](const std::string& svg) { return found(svg, "(L[0-9])").size(); };
  EXPECT_EQ(corners(drawn(PlotStyle::steps)), corners(drawn(PlotStyle::solid)) + 1);
}

TEST_F(DrawnLinePlot, BreaksALineWhereThereIsNoValue) {
  PlotSeries series{"a", {1e3, 2e3, 3e3, 4e3, 5e3}, {1, 2, std::nan(""), 3, 4}, {}, {}};
  series.style = PlotStyle::solid;
  plot_.series = {series};
  const auto pieces = [&] { return found(*draw(plot_), "( M[0-9])").size(); };
  const std::size_t broken = pieces();
  plot_.series[0].y[2] = 2.5;
  EXPECT_EQ(pieces() + 1, broken);
}

TEST_F(DrawnLinePlot, DrawsManyPointsAsDots) {
  PlotSeries& series = plot_.series[0];
  series = {"a", {}, {}, {}, {}};
  series.style = PlotStyle::points;
  for (int i = 1; i <= 2000; ++i) {
    series.x.push_back(i);
    series.y.push_back(1.0 + i % 40);
  }
  EXPECT_LT(draw(plot_)->size(), 60u * 1024u);
}

TEST_F(DrawnLinePlot, StandsInARowWithOthers) {
  plot_.width = 480;
  plot_.height = 300;
  const PlotRow row{.id = "row", .title = "T", .description = "D", .plots = {plot_, plot_, plot_}};
  const std::string svg = *draw(row);
  EXPECT_EQ(nesting_problem(svg), "");
  EXPECT_TRUE(holds(svg, "viewBox=\"0 0 960 600\""));
  EXPECT_TRUE(holds(svg, "<svg x=\"0\" y=\"300\""));
  const Texts ids = found(svg, "\\sid=[\"']([^\"']*)");
  EXPECT_EQ(unique(ids).size(), ids.size());
  EXPECT_THAT(ids, testing::Each(testing::StartsWith("row-")));
  EXPECT_THAT(ids, testing::IsSupersetOf(unique(found(svg, "href=[\"']#([^\"']*)"))));
}

TEST(PlotRowWithoutGnuplot, IsNothing) {
  const PlotRow row{.id = "row", .title = "T", .description = "D", .plots = {small_plot()}};
  EXPECT_EQ(draw(row, "phytobench-no-such-program"), std::nullopt);
}

TEST(LinePlotWithoutGnuplot, IsNothing) {
  EXPECT_EQ(draw(small_plot(), "phytobench-no-such-program"), std::nullopt);
  EXPECT_EQ(draw(small_plot(), "/no/such/folder/gnuplot"), std::nullopt);
}

TEST(LinePlotWithoutGnuplot, IsAnErrorIfAnotherProgramHasItsName) {
  for (const char* program : {"false", "echo"})
    EXPECT_THROW(draw(small_plot(), program), EnvironmentError) << program;
}

TEST(LinePlotContract, RefusesWhatCannotBeDrawn) {
  const auto expect_refused = [](void (*spoil)(LinePlot&)) {
    LinePlot plot = small_plot();
    spoil(plot);
    EXPECT_THROW(draw(plot), ContractViolation);
  };
  expect_refused([](LinePlot& plot) { plot.series.clear(); });
  expect_refused([](LinePlot& plot) { plot.series.resize(13, plot.series[0]); });
  expect_refused([](LinePlot& plot) { plot.series[0] = {"empty", {}, {}, {}, {}}; });
  expect_refused([](LinePlot& plot) { plot.series[0].x.pop_back(); });
  expect_refused([](LinePlot& plot) { plot.series[1].low.pop_back(); });
  expect_refused([](LinePlot& plot) { plot.series[0].x[0] = 0.0; });
  expect_refused([](LinePlot& plot) { plot.series[0].y[1] = -1.0; });
  expect_refused([](LinePlot& plot) { plot.series[1].low[1] = 0.0; });
  expect_refused([](LinePlot& plot) { plot.series[1].high[1] = std::nan(""); });
  expect_refused([](LinePlot& plot) { plot.series[0].x[1] = std::nan(""); });
  expect_refused([](LinePlot& plot) { plot.series[0].y.assign(3, std::nan("")); });
  expect_refused([](LinePlot& plot) { plot.series[0].colour = plot_colours; });
  expect_refused([](LinePlot& plot) { plot.id = ""; });
  expect_refused([](LinePlot& plot) { plot.id = "a\" b"; });
}

}  // namespace
}  // namespace phytobench
