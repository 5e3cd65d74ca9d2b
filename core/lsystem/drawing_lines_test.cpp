// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_lines.hpp"

#include <gtest/gtest.h>

#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

std::uint64_t one_style(const TurtleSegment&) {
  return 0;
}

std::uint64_t by_colour(const TurtleSegment& segment) {
  return segment.colour;
}

TEST(DrawnLines, FollowTheTurtle) {
  const Drawing drawing = TestWords(test_turtle(90.0)).drawn("F+F+FfF");
  const auto lines = drawn_lines(drawing, one_style);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].points.size(), 4u);
  EXPECT_EQ(lines[0].segments, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(lines[1].segments, (std::vector<std::uint32_t>{3}));
}

TEST(DrawnLines, GoOnAfterABranch) {
  const Drawing drawing = TestWords(test_turtle(90.0)).drawn("F[+F]F[-F]F");
  const auto lines = drawn_lines(drawing, one_style);
  // The first branch goes on with the stem, whose rest begins anew.
  std::size_t pieces = 0;
  for (const DrawnLine& line : lines) {
    EXPECT_EQ(line.points.size(), line.segments.size() + 1);
    pieces += line.segments.size();
    for (std::size_t i = 0; i < line.segments.size(); ++i) {
      EXPECT_EQ(drawing.segments[line.segments[i]].from, line.points[i]);
      EXPECT_EQ(drawing.segments[line.segments[i]].to, line.points[i + 1]);
    }
  }
  EXPECT_EQ(pieces, drawing.segments.size());
  EXPECT_LE(lines.size(), 3u);
}

TEST(DrawnLines, KeepStylesApart) {
  const Drawing drawing = TestWords(test_turtle(90.0)).drawn("F'F'FF");
  const auto lines = drawn_lines(drawing, by_colour);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2].style, 2u);
  EXPECT_EQ(lines[2].segments.size(), 2u);
}

}  // namespace
}  // namespace phytobench
