// SPDX-License-Identifier: MIT
#include "benchmarks/history/series_plot.hpp"

#include <algorithm>

#include "benchmarks/history/history_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<HistoryPoint> points_of(const std::vector<std::uint64_t>& counts) {
  std::vector<HistoryPoint> points;
  for (const std::uint64_t count : counts) {
    HistoryRun run = history_run_of("c" + std::to_string(points.size()));
    run.id = static_cast<std::int64_t>(points.size()) + 1;
    points.push_back({run, instructions_of("p<q>", count)});
  }
  return points;
}

std::ptrdiff_t stars(const std::string& text) {
  return std::count(text.begin(), text.end(), '*');
}

TEST(SeriesPlot, LinesHoldWhatCanBeCompared) {
  std::vector<HistoryPoint> points = points_of({1, 2, 3, 4});
  points[1].run.processor = "Model 2";
  points[2].run.flags = "-O2";
  const std::vector<HistoryLine> lines = comparable_lines(points);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].points.size(), 2u);
  EXPECT_THAT(lines[1].name, HasSubstr("Model 2"));
  for (HistoryPoint& point : points) point.value = counter_of("p", 1);
  EXPECT_EQ(comparable_lines(points).size(), 1u);
}

TEST(SeriesPlot, TextShowsEachRunAndBothEnds) {
  const std::string text = series_text({"", points_of({10, 30, 20})});
  EXPECT_EQ(stars(text), 3);
  EXPECT_THAT(text, HasSubstr("              30 | *\n"));
  EXPECT_THAT(text, HasSubstr("              10 |*\n"));
  EXPECT_THAT(text, HasSubstr("run 1 to run 3"));
  EXPECT_EQ(stars(series_text({"", points_of(std::vector<std::uint64_t>(500, 7))}, 60)), 60);
  EXPECT_EQ(stars(series_text({"", points_of({7})})), 1);
}

TEST(SeriesPlot, SvgSaysWhatItIsAndIsTheSameEachTime) {
  const std::vector<HistoryLine> lines = comparable_lines(points_of({10, 30, 20}));
  const std::string svg = series_svg(lines, "p<q> & more");
  EXPECT_THAT(svg, HasSubstr("<title>p&lt;q&gt; &amp; more</title>"));
  EXPECT_THAT(svg,
              HasSubstr("<desc>instructions of runs 1 to 3, between 10 and 30; lines: 1</desc>"));
  EXPECT_THAT(svg, HasSubstr("d=\"M100 208L362 28L624 118\""));
  EXPECT_THAT(svg, HasSubstr("currentColor"));
  EXPECT_THAT(svg, Not(HasSubstr("p<q>")));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(svg, series_svg(lines, "p<q> & more"));
  EXPECT_THAT(series_svg(comparable_lines(points_of({10})), "one"), HasSubstr("M362 118"));
}

TEST(SeriesPlot, StepIsNotedAndNoiseIsNot) {
  const std::vector<std::uint64_t> noisy = {1000, 1010, 990, 1005, 995, 1000, 1010, 990, 1005};
  EXPECT_EQ(step_note(points_of(noisy)), "");
  std::vector<std::uint64_t> stepped = noisy;
  for (std::size_t i = 6; i < 9; ++i) stepped[i] = 1200;
  EXPECT_EQ(step_note(points_of(stepped)),
            "note: the last 3 runs stand +20.00 % from the 6 before");
  stepped[6] = stepped[7] = 1000;  // one value alone is no level
  EXPECT_EQ(step_note(points_of(stepped)), "");
  EXPECT_EQ(step_note(points_of({1000, 1000, 1000, 2000, 2000, 2000})), "");
  // Counts without any noise: less than two in a thousand is no matter.
  EXPECT_EQ(step_note(points_of({1000, 1000, 1000, 1000, 1000, 1000, 1001, 1001, 1001})), "");
  EXPECT_NE(step_note(points_of({1000, 1000, 1000, 1000, 1000, 1000, 1003, 1003, 1003})), "");
}

}  // namespace
}  // namespace phytobench
