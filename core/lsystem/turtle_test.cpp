// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A vector in terms of the frame at the start: along H, L and U.
Vector3 in_start_frame(const Vector3& v) {
  return {v.y, -v.x, v.z};
}

TurtleFrame after(std::string_view text, TurtleConvention convention = TurtleConvention::words) {
  TestWords words(test_turtle(90.0, 1.0, TurtleStart::upwards, convention));
  const Drawing drawing = words.drawn(std::string("&(0)") + std::string(text));  // in space
  const TurtleFrame& frame = drawing.end_frame;
  return {in_start_frame(frame.heading), in_start_frame(frame.left), in_start_frame(frame.up)};
}

const Vector3 h{1, 0, 0}, l{0, 1, 0}, u{0, 0, 1};
const Vector3 right{0, -1, 0}, down{0, 0, -1}, behind{-1, 0, 0};

TEST(Turtle, TurnsAsTheWordsSay) {  // [Liebemann2017] eq. 2.7 to 2.16
  EXPECT_EQ(after("+").heading, l);
  EXPECT_EQ(after("-").heading, right);
  EXPECT_EQ(after("&").heading, down);
  EXPECT_EQ(after("^").heading, u);
  EXPECT_EQ(after("\\").up, l);  // rolling left: up tips to the left
  EXPECT_EQ(after("/").up, right);
  EXPECT_EQ(after("|").heading, behind);
  EXPECT_EQ(after("|").left, right);
  EXPECT_EQ(after("|").up, u);
}

TEST(Turtle, TurnsAsEachConventionSays) {
  const auto heading = [](const char* text, TurtleConvention c) { return after(text, c).heading; };
  const auto up = [](const char* text, TurtleConvention c) { return after(text, c).up; };
  EXPECT_EQ(heading("+", TurtleConvention::abop_matrices), right);
  EXPECT_EQ(heading("&", TurtleConvention::abop_matrices), u);
  EXPECT_EQ(up("\\", TurtleConvention::abop_matrices), right);
  EXPECT_EQ(heading("+", TurtleConvention::cpfg), l);
  EXPECT_EQ(heading("&", TurtleConvention::cpfg), down);
  EXPECT_EQ(up("\\", TurtleConvention::cpfg), right);
  EXPECT_EQ(heading("+", TurtleConvention::lpfg_uncorrected), l);
  EXPECT_EQ(heading("&", TurtleConvention::lpfg_uncorrected), u);
  EXPECT_EQ(up("\\", TurtleConvention::lpfg_uncorrected), right);
}

TEST(Turtle, TurnsAboutItsOwnAxes) {
  // After rolling left, left has become down: a turn to the left goes down.
  EXPECT_EQ(after("\\+").heading, down);
  EXPECT_EQ(after("+&").heading, down);
  EXPECT_EQ(after("&+").heading, l);
}

TEST(Turtle, StartsUpwardsOrInItsOwnFrame) {
  TestWords upwards(test_turtle(90.0)), local(test_turtle(90.0, 1.0, TurtleStart::local));
  EXPECT_EQ(upwards.drawn("F").end, (Vector3{0, 1, 0}));
  EXPECT_EQ(upwards.drawn("F+F").end, (Vector3{-1, 1, 0}));
  EXPECT_EQ(local.drawn("F").end, (Vector3{1, 0, 0}));
  EXPECT_EQ(local.drawn("F+F").end, (Vector3{1, 1, 0}));
  EXPECT_EQ(local.drawn("F&F").end, (Vector3{1, 0, -1}));
  TestWords by_angle(test_turtle(90.0, 1.0, TurtleStart::local));
  EXPECT_EQ(by_angle.drawn("F+(90)F").end, (Vector3{1, 1, 0}));
}

TEST(Turtle, LevelsItsLeft) {
  const Drawing drawing = TestWords(test_turtle(40.0)).drawn("+&/(70)$");
  EXPECT_NEAR(drawing.end_frame.left.y, 0.0, 1e-15);
  EXPECT_GT(drawing.end_frame.up.y, 0.0);
  EXPECT_LT(orthonormality_error(drawing.end_frame), 1e-15);
  const Drawing rolled = TestWords(test_turtle(40.0)).drawn("+&/(70)");
  EXPECT_EQ(drawing.end_frame.heading, rolled.end_frame.heading);
}

TEST(Turtle, DoesNotLevelWhereItLooksStraightUp) {
  const Drawing drawing = TestWords(test_turtle(40.0)).drawn("/$");
  const Drawing without = TestWords(test_turtle(40.0)).drawn("/");
  EXPECT_EQ(drawing.end_frame.left, without.end_frame.left);
}

TEST(Turtle, TakesLengthsAnglesAndWidthsFromParameters) {
  TestWords words(test_turtle(90.0));
  const Drawing drawing = words.drawn("F(2)+(180)F(3,0.5)f(4)F(1,0.25,99)F");
  ASSERT_EQ(drawing.segments.size(), 4u);
  EXPECT_EQ(drawing.segments[0].to, (Vector3{0, 2, 0}));
  EXPECT_EQ(drawing.segments[1].to, (Vector3{0, -1, 0}));
  EXPECT_EQ(drawing.segments[2].from, (Vector3{0, -5, 0}));
  EXPECT_EQ(drawing.segments[0].width, 1.0f);
  EXPECT_EQ(drawing.segments[1].width, 0.5f);
  EXPECT_EQ(drawing.segments[2].width, 0.25f);
  EXPECT_EQ(drawing.segments[3].width, 0.25f);  // the width stays
}

TEST(Turtle, WidthsAndColoursBelongToTheBranch) {
  TestWords words;
  const Drawing drawing = words.drawn("F[!'F!(9)'(7)F]F!F");
  ASSERT_EQ(drawing.segments.size(), 5u);
  const float widths[] = {1.0f, 0.7f, 9.0f, 1.0f, 0.7f};
  const std::uint16_t colours[] = {0, 1, 7, 0, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(drawing.segments[i].width, widths[i]) << i;
    EXPECT_EQ(drawing.segments[i].colour, colours[i]) << i;
  }
}

TEST(Turtle, DrawsWithTheLettersOfTheSystem) {
  TurtleSettings turtle;
  turtle.draws = "GH";
  turtle.moves = "fg";
  TestWords words(turtle);
  const Drawing drawing = words.drawn("GHfgFXG");  // F and X mean nothing here
  ASSERT_EQ(drawing.segments.size(), 3u);
  EXPECT_EQ(drawing.end, (Vector3{0, 5, 0}));
}

TEST(Turtle, CutsOffTheRestOfABranch) {
  TestWords words;
  const Drawing drawing = words.drawn("F[F%F[F(5)]F?P(0,0)]F");
  EXPECT_EQ(drawing.segments.size(), 3u);
  EXPECT_EQ(drawing.end, (Vector3{0, 2, 0}));
  EXPECT_EQ(words.drawn("F%F[F]F").segments.size(), 1u);
  EXPECT_EQ(words.drawn("F%").segments.size(), 1u);
  EXPECT_EQ(words.drawn("F[%]F").segments.size(), 2u);
}

TEST(Turtle, EnclosesPolygons) {
  TestWords words(test_turtle(90.0));
  const Drawing drawing = words.drawn("f'{f-F(2)[f].-f}F.");
  ASSERT_EQ(drawing.polygons.size(), 1u);
  EXPECT_EQ(drawing.polygons[0].colour, 1);
  const auto corners = corners_of(drawing, drawing.polygons[0]);
  const std::vector<Vector3> expected{{0, 1, 0}, {0, 2, 0}, {2, 2, 0},
                                      {3, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  EXPECT_EQ(std::vector<Vector3>(corners.begin(), corners.end()), expected);
  EXPECT_EQ(drawing.segments.size(), 2u);  // F draws inside, too
}

TEST(Turtle, ACutEndsAPolygonWhereItsBraceWouldBe) {
  TestWords words(test_turtle(90.0));
  const Drawing drawing = words.drawn("[{f+f%f{ff}f}f]{f}");
  ASSERT_EQ(drawing.polygons.size(), 2u);
  EXPECT_EQ(drawing.polygons[0].count, 3u);
  EXPECT_EQ(drawing.polygons[1].count, 2u);
}

TEST(Turtle, PolygonsMayCrossBrackets) {
  TestWords words(test_turtle(90.0));
  EXPECT_EQ(words.drawn("[{f][+f]f}").polygons.at(0).count, 4u);
}

auto refusal(const std::string& part) {
  return ThrowsMessage<InputError>(HasSubstr(part));
}

TEST(Turtle, RefusesPolygonsThatDoNotMatch) {
  TestWords words;
  EXPECT_THAT([&] { words.drawn("{f{f}f}"); }, refusal("polygons cannot nest"));
  EXPECT_THAT([&] { words.drawn("f}"); }, refusal("} without {"));
  EXPECT_THAT([&] { words.drawn("{f"); }, refusal("{ without }"));
}

TEST(Turtle, RefusesWhatIsNoWidthOrColour) {
  TestWords words;
  EXPECT_THAT([&] { words.drawn("!(-1)F"); }, refusal("-1 is no width"));
  EXPECT_THAT([&] { words.drawn("F(1,-2)"); }, refusal("-2 is no width"));
  EXPECT_THAT([&] { words.drawn("'(70000)F"); }, refusal("no number of a colour"));
  TurtleSettings wider;
  wider.width_factor = 1e6;
  EXPECT_THAT([&] { TestWords(wider).drawn("!!!!!!F"); }, refusal("is no width"));
}

TEST(Turtle, RefusesToLeaveTheRangeOfNumbers) {
  TestWords words(test_turtle(90.0, 1e29));
  EXPECT_NO_THROW(words.drawn("FFFFFFFFF"));
  EXPECT_THAT([&] { words.drawn("FFFFFFFFFFF"); }, refusal("farther than 1e+30"));
  EXPECT_THAT([&] { words.drawn("^fffffffffff"); }, refusal("farther than 1e+30"));
}

TEST(Turtle, StoresAMillionStatesAndNoMore) {
  TestWords words;
  const std::string opened(most_turtle_states, '['), closed(most_turtle_states, ']');
  EXPECT_EQ(words.drawn(opened + "F" + closed).segments.size(), 1u);
  EXPECT_THAT([&] { words.drawn("[" + opened + "F" + closed + "]"); },
              refusal("inside each other"));
}

TEST(Turtle, ExpectsBracketsThatMatchAndAllParameters) {
  TestWords words;
  EXPECT_THROW(words.drawn("F]F"), ContractViolation);
  EXPECT_THROW(words.drawn("[F"), ContractViolation);
  Word word = words.word("F(1)F(2)");
  word.parameters.resize_for_overwrite(1);
  EXPECT_THROW(draw(words.system, word), ContractViolation);
}

TEST(Turtle, KnowsWhetherASystemLeavesThePlane) {
  for (const char* text : {"F", "F+F-|", "{f+f}", "![']", "?P(0,0)"}) {
    TestWords words;
    words.word(text);
    EXPECT_TRUE(is_planar(words.system)) << text;
  }
  for (const char* text : {"&", "^", "\\", "/(3)", "$"}) {
    TestWords words;
    words.word(text);
    EXPECT_FALSE(is_planar(words.system)) << text;
  }
}

}  // namespace
}  // namespace phytobench
