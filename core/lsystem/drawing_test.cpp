// SPDX-License-Identifier: MIT
// Published drawings: counts and lengths by closed forms, boxes by an independent script that
// multiplies the matrices of [Liebemann2017] eq. 2.7 to 2.9.
#include "core/lsystem/drawing.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

constexpr double printed_digits = 1e-6;  // boxes are compared to what was written down

void expect_box(const BoundingBox& box, const Vector3& low, const Vector3& high) {
  EXPECT_NEAR(box.low().x, low.x, printed_digits);
  EXPECT_NEAR(box.low().y, low.y, printed_digits);
  EXPECT_NEAR(box.low().z, low.z, printed_digits);
  EXPECT_NEAR(box.high().x, high.x, printed_digits);
  EXPECT_NEAR(box.high().y, high.y, printed_digits);
  EXPECT_NEAR(box.high().z, high.z, printed_digits);
}

std::string koch_island_word(int steps) {
  return rewritten("F-F-F-F", {{'F', "F+F-F-FF+F+F-F"}}, steps);
}

Drawing koch_island(int steps) {
  return TestWords(test_turtle(90.0, 400.0 / std::pow(4.0, steps))).drawn(koch_island_word(steps));
}

class KochIsland : public testing::TestWithParam<int> {};

TEST_P(KochIsland, HasItsClosedForms) {  // [Liebemann2017] eq. 2.6, fig. 2.4
  const int n = GetParam();
  const Drawing drawing = koch_island(n);
  const auto count = static_cast<std::size_t>(4 * std::pow(8, n));
  EXPECT_TRUE(drawing.planar);
  EXPECT_EQ(drawing.segments.size(), count);
  EXPECT_EQ(total_length(drawing), 1600.0 * std::pow(2.0, n));
  EXPECT_TRUE(is_one_line(drawing));
  EXPECT_EQ(closing_gap(drawing), 0.0);
  EXPECT_EQ(signed_area(drawing), -160000.0);  // clockwise
  const DistinctParts parts = distinct_parts(drawing);
  EXPECT_EQ(parts.segments, count);
  EXPECT_EQ(parts.most_often, 1u);
  EXPECT_EQ(parts.vertices, count);
  // 400 (1 - 4^-n) / 3 on each side, and exactly so: all lengths are binary fractions.
  const double overhang = 400.0 * (1.0 - std::pow(4.0, -n)) / 3.0;
  const BoundingBox box = segment_box(drawing);
  EXPECT_EQ(box.low(), (Vector3{-overhang, -overhang, 0.0}));
  EXPECT_EQ(box.high(), (Vector3{400.0 + overhang, 400.0 + overhang, 0.0}));
}
INSTANTIATE_TEST_SUITE_P(Steps, KochIsland, testing::Range(0, 5));

TEST(Drawing, OfAKochIslandHasWholeCoordinates) {
  const Drawing drawing = TestWords(test_turtle(90.0)).drawn(koch_island_word(3));
  for (const TurtleSegment& segment : drawing.segments) {
    ASSERT_EQ(segment.to.x, std::round(segment.to.x));
    ASSERT_EQ(segment.to.y, std::round(segment.to.y));
  }
}

TEST(Drawing, OfAKochIslandHasItsWord) {
  const std::size_t lengths[] = {7, 59, 475, 3803};
  const std::ptrdiff_t plus[] = {0, 12, 108, 876}, minus[] = {3, 15, 111, 879};
  for (int n = 0; n < 4; ++n) {
    const std::string word = koch_island_word(n);
    EXPECT_EQ(word.size(), lengths[n]);
    EXPECT_EQ(std::count(word.begin(), word.end(), '+'), plus[n]);
    EXPECT_EQ(std::count(word.begin(), word.end(), '-'), minus[n]);
  }
}

TEST(Drawing, OfLiebemannsFirstBranchingHasItsBox) {  // fig. 2.5a
  const Drawing drawing =
      TestWords(test_turtle(25.0, 18.0)).drawn(rewritten("F", {{'F', "FF-[-F+F+F]+[+F-F-F]"}}, 4));
  EXPECT_EQ(drawing.segments.size(), 4096u);
  expect_box(segment_box(drawing), {-217.145753, 0.0, 0.0}, {452.624431, 985.742483, 0.0});
}

TEST(Drawing, OfLiebemannsSecondBranchingHasItsBox) {  // fig. 2.5b
  const Drawing drawing =
      TestWords(test_turtle(25.0, 15.0)).drawn(rewritten("F", {{'F', "F[-F]F[+F][F]"}}, 5));
  EXPECT_EQ(drawing.segments.size(), 3125u);
  expect_box(segment_box(drawing), {-295.625614, 0.0, 0.0}, {223.074191, 945.0, 0.0});
}

TEST(Drawing, OfTheTernaryTreeHasItsBoxes) {  // [Liebemann2017] eq. 2.17, fig. 2.6
  const auto drawn = [](double pitch) {
    return TestWords(test_turtle(90.0, 1.0, TurtleStart::local)).drawn(ternary_word(8, pitch));
  };
  const Drawing narrow = drawn(18.95), wide = drawn(36.0);
  EXPECT_FALSE(narrow.planar);
  EXPECT_EQ(narrow.segments.size(), 13120u);
  expect_box(segment_box(narrow), {0.0, -1197.108651, -1200.537672},
             {2312.732188, 1135.355224, 1460.05989});
  expect_box(segment_box(wide), {0.0, -1524.102902, -1545.308698},
             {2135.762593, 1477.325773, 1748.29983});
  double length = 0.0;
  for (int k = 1; k <= 8; ++k) length += 4.0 * std::pow(3.0, k - 1) * 50.0 * std::pow(1.3, 8 - k);
  EXPECT_NEAR(length, 770922.66974, 1e-5);
  EXPECT_NEAR(total_length(narrow), length, 1e-7);
  EXPECT_NEAR(total_length(wide), length, 1e-7);
}

TEST(Drawing, OfTheKochCurveEndsAtAPowerOfThree) {  // [Brzoska2019] eq. 5
  for (int n = 0; n <= 6; ++n) {
    const Drawing drawing = TestWords(test_turtle(60.0, 1.0, TurtleStart::local))
                                .drawn(rewritten("F", {{'F', "F+F--F+F"}}, n));
    EXPECT_EQ(drawing.segments.size(), static_cast<std::size_t>(std::pow(4, n)));
    EXPECT_NEAR(total_length(drawing), std::pow(4.0, n), 1e-12 * std::pow(4.0, n));
    EXPECT_EQ(drawing.end.x, std::pow(3.0, n));  // cosines of 60 degrees are exactly one half
    EXPECT_NEAR(drawing.end.y, 0.0, 1e-12);
    EXPECT_EQ(drawing.end_frame.heading, (Vector3{1, 0, 0}));
  }
}

TEST(Drawing, OfBrzoskasPlantHasItsBox) {  // eq. 6, fig. 14
  const Drawing drawing =
      TestWords(test_turtle(10.0))
          .drawn(rewritten("X", {{'X', "F[+++FX]F[---FX]F[++F-FX][F-FX]"}, {'F', "FF"}}, 7));
  EXPECT_EQ(drawing.segments.size(), 73152u);
  expect_box(segment_box(drawing), {-247.517668, 0.0, 0.0}, {234.787917, 631.156362, 0.0});
}

TEST(Drawing, OfTheBushHasItsPolygons) {  // [Lintermann1997] sec. 2.1
  const std::size_t polygons[] = {0, 0, 3, 12, 42, 135, 420};
  const std::size_t segments[] = {0, 3, 12, 42, 135, 420, 1284};
  for (int n = 0; n <= 6; ++n) {
    const Drawing drawing = TestWords(test_turtle(22.5)).drawn(bush_word(n, 5, 7, 5));
    EXPECT_EQ(drawing.polygons.size(), polygons[n]) << n;
    EXPECT_EQ(drawing.segments.size(), segments[n]) << n;
    for (const TurtlePolygon& polygon : drawing.polygons) EXPECT_EQ(polygon.count, 7u);
  }
}

TEST(Drawing, OfTheBushIsFlatWithEightSlashes) {
  constexpr double rounding = 1e-9;
  const Drawing full = TestWords(test_turtle(22.5)).drawn(bush_word(5, 5, 7, 5));
  EXPECT_EQ(distinct_parts(full, rounding).segments, 420u);
  expect_box(segment_box(full), {-7.595377, 0.0, -7.56912}, {7.56912, 11.419351, 5.808215});
  const Drawing flat = TestWords(test_turtle(22.5)).drawn(bush_word(5, 8, 8, 8));
  const DistinctParts parts = distinct_parts(flat, rounding);
  EXPECT_EQ(parts.segments, 86u);
  EXPECT_GT(parts.most_often, 1u);
  EXPECT_LT(segment_box(flat).extent().x, rounding);
  // Its leaves stand out of the plane by half their width.
  EXPECT_NEAR(polygon_box(flat).extent().x, 2.0 * std::sin(std::acos(-1.0) / 8.0), rounding);
}

TEST(Drawing, OfALeafIsAHexagon) {
  const Drawing drawing = TestWords(test_turtle(22.5)).drawn("{-f+f+f-|-f+f+f}");
  ASSERT_EQ(drawing.polygons.size(), 1u);
  const auto corners = corners_of(drawing, drawing.polygons[0]);
  ASSERT_EQ(corners.size(), 7u);
  EXPECT_LT(norm(corners.front() - corners.back()), 1e-15);
  EXPECT_EQ(distinct_point_count(corners, 1e-12), 6u);
  const double eighth = std::acos(-1.0) / 8.0;
  const Vector3 area = vector_area(corners);
  EXPECT_NEAR(area.z, 2.0 * std::sin(eighth) + std::sin(2.0 * eighth), 1e-14);
  EXPECT_NEAR(area.z, 1.4724736, 5e-8);
  EXPECT_NEAR(polygon_box(drawing).extent().y, 2.8477591, 5e-8);
  EXPECT_NEAR(polygon_box(drawing).extent().x, 0.7653669, 5e-8);
}

TEST(Drawing, OfAnEmptyWordIsAPoint) {
  const Drawing drawing = TestWords().drawn("AX");
  EXPECT_TRUE(drawing.segments.empty());
  EXPECT_EQ(drawing.end, Vector3{});
  EXPECT_TRUE(segment_box(drawing).empty());
}

}  // namespace
}  // namespace phytobench
