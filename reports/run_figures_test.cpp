// SPDX-License-Identifier: MIT
#include "reports/run_figures.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

TEST(SvgCaption, IsTheRootsLabelAndElseItsTitle) {
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\" aria-label=\"A\"><title>B</title></svg>"), "A");
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\">\n  <title>B</title></svg>"), "B");
  EXPECT_EQ(svg_caption("<?xml version=\"1.0\"?><svg aria-label=\"A\"/>"), "A");
}

TEST(SvgCaption, IsNotThatOfAPartInside) {
  EXPECT_EQ(svg_caption("<svg viewBox=\"0 0 1 1\"><svg aria-label=\"part\"/></svg>"), "");
  EXPECT_EQ(svg_caption("<svg><g><title>part</title></g></svg>"), "");
  EXPECT_EQ(svg_caption("<svg"), "");
  EXPECT_EQ(svg_caption("no picture"), "");
}

TEST(SvgCaption, IsPlainTextOnceUnescaped) {
  EXPECT_EQ(svg_caption("<svg aria-label=\"a &lt; b &amp;amp; &quot;c&quot; > d\"/>"),
            "a < b &amp; \"c\" > d");
}

TEST(SvgWidth, IsThatOfTheViewBoxWhereLettersStand) {
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 366.0 330\"><text>x</text></svg>"), 366.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"-4 -1 8 3\"><text>x</text></svg>"), 8.0);
}

TEST(SvgWidth, IsNotTakenForPixelsInAPictureWithoutLetters) {
  EXPECT_GT(svg_width("<svg viewBox=\"-4 -1.6 8 3.4\"><g/></svg>"), 300.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 948 330\"><g/></svg>"), 948.0);
}

TEST(SvgWidth, IsZeroWithoutAUsableViewBox) {
  EXPECT_EQ(svg_width("<svg><svg viewBox=\"0 0 9 9\"/></svg>"), 0.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 wide 9\"><text/></svg>"), 0.0);
  EXPECT_EQ(svg_width("<svg viewBox=\"0 0 -5 9\"><text/></svg>"), 0.0);
}

TEST(FigureOrder, FollowsTheNumbersAndThenTheNames) {
  const std::vector<std::string> ordered = {"p/z/figure-2.1.svg",
                                            "p/c/figure-4.7.svg",
                                            "p/c/figure-4.7-step-40.svg",
                                            "p/c/figure-4.7-step-100.svg",
                                            "p/b/figure-4.11.svg",
                                            "p/y/figures-7.6-7.7.svg",
                                            "p/x/figure-7.8.svg",
                                            "p/a/figure-10.svg",
                                            "p/a/figure-of-a-tree.svg",
                                            "p/a/growth-law-4.3.svg",
                                            "p/b/a.svg"};
  for (std::size_t i = 0; i < ordered.size(); ++i)
    for (std::size_t j = 0; j < ordered.size(); ++j)
      EXPECT_EQ(is_figure_before(ordered[i], ordered[j]), i < j) << ordered[i] << " " << ordered[j];
}

TEST(FiguresOf, KeepsToItsWorkAndFallsBackToTheName) {
  const auto figures = figures_of("p", {{"p/e/b.svg", "<svg/>"},
                                        {"pp/e/c.svg", "<svg/>"},
                                        {"p/e/figure-1.svg",
                                         "<svg viewBox=\"0 0 400 9\" aria-label=\"One\"><text/>"
                                         "</svg>"}});
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0]["caption"], "One");
  EXPECT_EQ(figures[0]["width"], "400");
  EXPECT_EQ(figures[0]["least_width"], "300");
  EXPECT_EQ(figures[1]["caption"], "p/e/b.svg");
  EXPECT_EQ(figures[1]["least_width"], "0");
}

}  // namespace
}  // namespace phytobench
