// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/svg_path_text.hpp"
#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

Drawing square() {
  return TestWords(test_turtle(90.0)).drawn("F+F+F+F");
}

Drawing koch_curves(int steps) {
  return TestWords(test_turtle(90.0)).drawn(rewritten("F-F-F-F", {{'F', "F+F-F-FF+F+F-F"}}, steps));
}

void expect_well_formed(const std::string& svg) {
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_EQ(occurrences(svg, "<"), occurrences(svg, ">"));
  EXPECT_EQ(occurrences(svg, "<path"), occurrences(svg, "/>"));
  EXPECT_EQ(occurrences(svg, "\"") % 2, 0u);
  for (const char* no_number : {"nan", "inf"})
    EXPECT_EQ(occurrences(svg, no_number), 0u) << no_number;
}

TEST(DrawingSvg, IsWellFormed) {
  expect_well_formed(drawing_svg(square(), "a square"));
  expect_well_formed(drawing_svg(Drawing{}, "nothing"));
  expect_well_formed(drawing_svg(TestWords().drawn("F(0)"), "a point"));
  expect_well_formed(drawing_svg(TestWords().drawn("F(1e-320)"), "less than a point"));
  expect_well_formed(drawing_svg(TestWords().drawn("F(1e29)"), "large"));
  expect_well_formed(drawing_svg(TestWords().drawn("!(0)F"), "no width"));
  expect_well_formed(
      drawing_svg(TestWords(test_turtle(22.5)).drawn(bush_word(4, 5, 7, 5)), "a bush"));
}

TEST(DrawingSvg, EscapesItsTitle) {
  EXPECT_THAT(drawing_svg(square(), "a<b & c"), HasSubstr("<title>a&lt;b &amp; c</title>"));
}

TEST(DrawingSvg, IsTheDrawing) {
  // 1000 pixels in hundredths: up from the lower right corner, left, down, and closed.
  const std::string svg = drawing_svg(square(), "");
  EXPECT_THAT(svg, HasSubstr("viewBox=\"-10 -10 1020 1020\""));
  EXPECT_THAT(svg, HasSubstr("d=\"M100000 100000v-100000h-100000v100000z\""));
}

TEST(DrawingSvg, JoinsAndStraightensLines) {
  const std::string svg = drawing_svg(TestWords(test_turtle(90.0)).drawn("FFF+FF"), "");
  EXPECT_EQ(occurrences(svg, "M"), 1u);
  EXPECT_THAT(svg, HasSubstr("v-100000h-66667\""));
}

TEST(DrawingSvg, IsSmall) {
  EXPECT_LT(drawing_svg(koch_curves(3), "2048 segments").size(), 14'000u);
  const Drawing plant =
      TestWords(test_turtle(25.0)).drawn(rewritten("F", {{'F', "FF-[-F+F+F]+[+F-F-F]"}}, 4));
  EXPECT_LT(drawing_svg(plant, "4096 segments").size(), 60'000u);
}

TEST(DrawingSvg, FollowsThePage) {
  const std::string svg = drawing_svg(TestWords(test_turtle(60.0)).drawn("F{f+f+f}"), "");
  EXPECT_THAT(svg, HasSubstr("stroke=\"currentColor\""));
  EXPECT_THAT(svg, HasSubstr("fill=\"currentColor\""));
  EXPECT_THAT(svg, Not(HasSubstr("#")));
}

TEST(DrawingSvg, TakesColoursInTurn) {
  DrawingSvgOptions options;
  options.colours = {"#112233", "#445566"};
  const std::string svg =
      drawing_svg(TestWords(test_turtle(60.0)).drawn("F''F'{f+f+f}"), "", options);
  EXPECT_EQ(occurrences(svg, "stroke=\"#112233\""), 1u);  // 0 and 2 are the same
  EXPECT_EQ(occurrences(svg, "fill=\"#445566\""), 1u);
  options.colours = {"green"};
  EXPECT_THROW(drawing_svg(square(), "", options), InputError);
}

TEST(DrawingSvg, DrawsWidthsThatDiffer) {
  const auto width_of = [](const char* word) {
    return drawing_svg(TestWords(test_turtle(90.0)).drawn(word), "");
  };
  EXPECT_EQ(occurrences(width_of("F!F!F"), "stroke-width"), 3u);
  EXPECT_EQ(occurrences(width_of("FFF"), "stroke-width"), 1u);
  DrawingSvgOptions options;
  options.widest_line = 8.0;
  EXPECT_THAT(drawing_svg(TestWords().drawn("F!(0.5)F"), "", options),
              testing::AllOf(HasSubstr("stroke-width=\"800\""), HasSubstr("stroke-width=\"400\"")));
}

TEST(DrawingSvg, TurnsAllPolygonsTheSameWayRound) {
  // The two halves of a square, one to the left, the other to the right.
  const std::string svg = drawing_svg(TestWords(test_turtle(90.0)).drawn("[{f+f}][{+f-f}]"), "");
  EXPECT_THAT(svg, HasSubstr("\"M0 0h100000v100000zM100000 100000h-100000v-100000z\""));
}

TEST(DrawingSvg, ProjectsSpace) {
  TestWords words(test_turtle(90.0));
  const Drawing drawing = words.drawn("F[&F(2)]F");  // away from the eye: -z
  const std::string front = drawing_svg(drawing, "");
  EXPECT_THAT(front, HasSubstr("viewBox=\"-10 -10 20 1020\""));
  DrawingSvgOptions from_side;
  from_side.azimuth_deg = 0.0;  // from +x; -z is at the right
  EXPECT_THAT(drawing_svg(drawing, "", from_side), HasSubstr("viewBox=\"-10 -10 1020 1020\""));
  EXPECT_THAT(front, HasSubstr("opacity=\"0.73\""));  // halfway to the far end
}

TEST(DrawingSvg, RefusesWhatNobodyCouldLookAt) {
  Drawing drawing;
  drawing.segments.resize(2'000'001);
  EXPECT_THAT([&] { drawing_svg(drawing, ""); },
              testing::ThrowsMessage<InputError>(HasSubstr("2000001 segments")));
}

TEST(GridLine, DropsWhatIsNotSeen) {
  using Line = std::vector<GridPoint>;
  EXPECT_EQ(grid_line({{0, 0}, {1, 1}, {3, 3}, {3, 3}, {3, 4}}), (Line{{0, 0}, {3, 3}, {3, 4}}));
  EXPECT_EQ(grid_line({{0, 0}, {2, 0}, {1, 0}}), (Line{{0, 0}, {2, 0}, {1, 0}}));  // there and back
  EXPECT_EQ(grid_line({{5, 5}, {5, 5}}), (Line{{5, 5}}));
}

TEST(SvgPathText, IsShortAndUnambiguous) {
  SvgPathText path;
  path.add_line({{-1, -2}, {3, 4}, {2, 9}, {2, 10}, {-5, 3}});
  EXPECT_EQ(path.text(), "M-1-2l4 6-1 5v1l-7-7");
  SvgPathText dot;
  dot.add_line({{7, 8}});
  EXPECT_EQ(dot.text(), "M7 8h0");
  SvgPathText outline;
  outline.add_outline({{0, 0}, {4, 0}, {0, 3}});
  EXPECT_EQ(outline.text(), "M0 0h4l-4 3z");
}

}  // namespace
}  // namespace phytobench
