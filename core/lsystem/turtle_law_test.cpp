// SPDX-License-Identifier: MIT
// What must hold for every word, before any number is compared.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/test_words.hpp"
#include "core/lsystem/turtle.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// The three ways to stand and turn.
struct Kind {
  const char* name;
  const char* letters;  // to make words of
  const char* always;   // a symbol that decides the kind
  double angle_deg;
};

constexpr Kind kinds[] = {
    {"table", "FFf+-|", "+", 25.0},
    {"angle", "FFf+-|", "+(17.3)", 18.95},
    {"space", "FFf+-|&^\\/$!'", "&", 37.1},
};

std::string random_word(const Kind& kind, std::uint64_t seed, std::size_t size) {
  const std::string_view letters = kind.letters;
  CounterStream stream(seed, 0);
  std::string word = kind.always;
  for (std::size_t i = 0; i < size; ++i)
    word +=
        letters[static_cast<std::size_t>(stream.next_unit() * static_cast<double>(letters.size()))];
  return word;
}

bool same_frame(const TurtleFrame& a, const TurtleFrame& b) {
  return a.heading == b.heading && a.left == b.left && a.up == b.up;
}

bool same_segment(const TurtleSegment& a, const TurtleSegment& b) {
  return a.from == b.from && a.to == b.to && a.width == b.width && a.colour == b.colour;
}

class TurtleLaw : public testing::TestWithParam<Kind> {
 protected:
  TestWords words{test_turtle(GetParam().angle_deg)};
  std::string some(std::uint64_t seed, std::size_t size = 90) const {
    return random_word(GetParam(), seed, size);
  }
};

TEST_P(TurtleLaw, AClosedBracketGivesBackEveryBit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::string before = some(3 * seed), inside = some(3 * seed + 1, 70),
                      after = some(3 * seed + 2, 70);
    const Drawing with = words.drawn(before + "[" + inside + "[" + inside + "]]" + after);
    const Drawing without = words.drawn(before + after);
    EXPECT_EQ(with.end, without.end);
    EXPECT_TRUE(same_frame(with.end_frame, without.end_frame));
    const Drawing start = words.drawn(before);
    const std::size_t skipped = with.segments.size() - without.segments.size();
    for (std::size_t i = 0; i < without.segments.size(); ++i)
      EXPECT_TRUE(same_segment(without.segments[i],
                               with.segments[i < start.segments.size() ? i : i + skipped]));
  }
}

TEST_P(TurtleLaw, TheFrameIsOrthonormalAndRightHanded) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TurtleFrame frame = words.drawn(some(seed, 500)).end_frame;
    EXPECT_LT(orthonormality_error(frame), 1e-14);
    EXPECT_LT(norm(cross(frame.heading, frame.left) - frame.up), 1e-14);
  }
}

TEST_P(TurtleLaw, TheWayBackLeadsBack) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::string there = some(seed);
    std::erase(there, '$');  // cannot be undone
    std::string back;
    bool in_space = false;
    for (std::size_t i = there.size(); i-- > std::string_view(GetParam().always).size();) {
      const std::string_view turns = "+-&^\\/";
      const std::size_t turn = turns.find(there[i]);
      in_space = in_space || turn >= 2;
      // After | the turtle's left is its right, and its up still its up.
      if (there[i] == 'F' || there[i] == 'f')
        back += "|f|";
      else if (turn != std::string_view::npos)
        back += turns[turn ^ 1];
      else if (there[i] == '|')
        back += '|';
    }
    const Drawing round = words.drawn(there + back);
    const Drawing start = words.drawn(GetParam().always);
    EXPECT_LT(norm(round.end), 1e-12) << there;
    EXPECT_LT(norm(round.end_frame.heading - start.end_frame.heading), 1e-13);
    if (!in_space) {
      EXPECT_EQ(round.end_frame.heading, start.end_frame.heading);
    }
  }
}

TEST_P(TurtleLaw, TwiceTheStepIsTwiceTheDrawing) {
  TestWords larger(test_turtle(GetParam().angle_deg, 2.0));
  const std::string word = some(5, 300);
  const Drawing once = words.drawn(word), twice = larger.drawn(word);
  ASSERT_EQ(once.segments.size(), twice.segments.size());
  for (std::size_t i = 0; i < once.segments.size(); ++i)
    EXPECT_EQ(twice.segments[i].to, 2.0 * once.segments[i].to);
}

TEST_P(TurtleLaw, ConventionsChangeNeitherLengthsNorCounts) {
  const std::string word = some(6, 300);
  const Drawing by_words = words.drawn(word);
  for (const TurtleConvention convention : {TurtleConvention::abop_matrices, TurtleConvention::cpfg,
                                            TurtleConvention::lpfg_uncorrected}) {
    TestWords other(test_turtle(GetParam().angle_deg, 1.0, TurtleStart::upwards, convention));
    const Drawing drawing = other.drawn(word);
    EXPECT_EQ(drawing.segments.size(), by_words.segments.size());
    EXPECT_NEAR(total_length(drawing), total_length(by_words), 1e-10);
  }
}

TEST_P(TurtleLaw, TheTreeAndTheDrawingAreTheSame) {
  std::string word;
  for (const char c : some(7, 200)) word += c == 'f' ? 'F' : c;
  const Drawing drawing = words.drawn(word + "[" + word + "]" + word);
  const TurtleTree tree = words.tree(word + "[" + word + "]" + word);
  ASSERT_EQ(tree.skeleton.edge_count(), drawing.segments.size());
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    EXPECT_EQ(tree.skeleton.positions()[i + 1], drawing.segments[i].to);
    EXPECT_EQ(tree.skeleton.position(tree.skeleton.parents()[i + 1]), drawing.segments[i].from);
    EXPECT_EQ(tree.widths[i + 1], drawing.segments[i].width);
    EXPECT_EQ(tree.colours[i + 1], drawing.segments[i].colour);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TurtleLaw, testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

// What a law above would say about a turtle that is wrong.
TEST(TurtleLawCheckers, SeeASkewedFrame) {
  TurtleFrame frame;
  EXPECT_EQ(orthonormality_error(frame), 0.0);
  frame.left = {-1.0, 1e-9, 0.0};
  EXPECT_NEAR(orthonormality_error(frame), 1e-9, 1e-12);
  frame.left = {-1.0 - 1e-9, 0.0, 0.0};
  EXPECT_GT(orthonormality_error(frame), 1e-9);
  EXPECT_FALSE(same_frame(frame, TurtleFrame{}));
}

std::string repeated(const std::string& piece, std::size_t times) {
  std::string word;
  for (std::size_t i = 0; i < times; ++i) word += piece;
  return word;
}

TEST(TurtleExactnessLaw, AMillionTurnsInSpaceKeepTheFrame) {
  TestWords words(test_turtle(137.5077640500378));
  const TurtleFrame frame =
      words.drawn(repeated("+&/-(77.7)^(0.1)\\(201.3)+(12.34567)&/(3.3)^", 100'000)).end_frame;
  EXPECT_LT(orthonormality_error(frame), 1e-12);
  EXPECT_LT(norm(cross(frame.heading, frame.left) - frame.up), 1e-12);
}

TEST(TurtleExactnessLaw, QuarterTurnsInSpaceAreExact) {
  TestWords words(test_turtle(90.0));
  const Drawing drawing = words.drawn(repeated("F+F&F\\FF-F^F/F|F", 1000));
  for (const TurtleSegment& segment : drawing.segments)
    for (const double value : {segment.to.x, segment.to.y, segment.to.z})
      ASSERT_EQ(value, std::round(value));
  EXPECT_EQ(orthonormality_error(drawing.end_frame), 0.0);
}

TEST(TurtleExactnessLaw, HeadingsInThePlaneDoNotDrift) {
  TestWords table(test_turtle(25.0));  // 1,000,001 turns are 25 degrees more than whole turns
  const TurtleFrame by_counting = table.drawn(repeated("+", 1'000'001)).end_frame;
  const PlaneDirection expected = plane_direction(90.0 + std::fmod(25.0 * 1'000'001, 360.0));
  EXPECT_EQ(by_counting.heading, (Vector3{expected.x, expected.y, 0.0}));
  TestWords angle(test_turtle(18.95));
  const TurtleFrame frame =
      angle.drawn(repeated("+(17.3)-(0.7)+", 300'000) + repeated("-+(0.7)-(17.3)", 300'000))
          .end_frame;
  EXPECT_EQ(frame.heading, (Vector3{0.0, 1.0, 0.0}));
}

TEST(TurtleExactnessLaw, AnglesThatDivideTheCircleCloseIt) {
  for (const int corners : {3, 5, 6, 7, 9, 11, 360, 1000, 7919}) {
    TestWords words(test_turtle(360.0 / corners));
    const Drawing drawing = words.drawn(repeated("F+", static_cast<std::size_t>(corners)));
    EXPECT_EQ(drawing.end_frame.heading, (Vector3{0.0, 1.0, 0.0})) << corners;
    EXPECT_LT(norm(drawing.end), 1e-12 * corners) << corners;
  }
}

TEST(TurtleExactnessLaw, TableAndAngleAgree) {
  TestWords table(test_turtle(22.5)), angle(test_turtle(22.5));
  const Kind kind{"", "FFf+-|", "F", 22.5};
  const std::string word = random_word(kind, 9, 1000);
  const Drawing counted = table.drawn(word);
  const Drawing added = angle.drawn("+(0)" + word);  // a turn with a parameter forbids the table
  ASSERT_EQ(counted.segments.size(), added.segments.size());
  for (std::size_t i = 0; i < counted.segments.size(); ++i)
    EXPECT_TRUE(same_segment(counted.segments[i], added.segments[i]));
}

TEST(TurtleExactnessLaw, PlaneAndSpaceAgree) {
  TestWords plane(test_turtle(25.0)), space(test_turtle(25.0));
  const Kind kind{"", "FFf+-|", "F", 25.0};
  const std::string word = random_word(kind, 10, 1000);
  const Drawing flat = plane.drawn(word), deep = space.drawn("&(0)" + word);
  EXPECT_TRUE(flat.planar);
  EXPECT_FALSE(deep.planar);
  ASSERT_EQ(flat.segments.size(), deep.segments.size());
  for (std::size_t i = 0; i < flat.segments.size(); ++i)
    EXPECT_LT(norm(flat.segments[i].to - deep.segments[i].to), 1e-11);
}

TEST(TurtleExactnessLaw, PlaneDirectionsAreSymmetric) {
  for (double degrees = -720.0; degrees <= 720.0; degrees += 7.5) {
    const PlaneDirection d = plane_direction(degrees), quarter = plane_direction(degrees + 90.0),
                         whole = plane_direction(degrees + 360.0);
    EXPECT_EQ(quarter.x, 0.0 - d.y);
    EXPECT_EQ(quarter.y, d.x);
    EXPECT_EQ(whole.x, d.x);
    EXPECT_EQ(whole.y, d.y);
    EXPECT_NEAR(d.x, std::cos(degrees * std::acos(-1.0) / 180.0), 1e-14);
    EXPECT_NEAR(d.y, std::sin(degrees * std::acos(-1.0) / 180.0), 1e-14);
  }
  EXPECT_EQ(plane_direction(30.0).y, 0.5);
  EXPECT_EQ(plane_direction(120.0).x, -0.5);
  EXPECT_EQ(plane_direction(45.0).x, plane_direction(45.0).y);
}

}  // namespace
}  // namespace phytobench
