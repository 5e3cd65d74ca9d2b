// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_measures.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

Drawing of(std::initializer_list<TurtleSegment> segments) {
  Drawing drawing;
  drawing.segments = segments;
  return drawing;
}

TEST(DrawingMeasures, OfNothing) {
  const Drawing nothing;
  EXPECT_EQ(total_length(nothing), 0.0);
  EXPECT_TRUE(segment_box(nothing).empty());
  EXPECT_TRUE(polygon_box(nothing).empty());
  EXPECT_TRUE(is_one_line(nothing));
  EXPECT_EQ(closing_gap(nothing), 0.0);
  EXPECT_EQ(signed_area(nothing), 0.0);
  EXPECT_EQ(distinct_parts(nothing).segments, 0u);
  EXPECT_EQ(distinct_parts(nothing).vertices, 0u);
}

TEST(DrawingMeasures, OfASquare) {
  TestWords words(test_turtle(90.0));
  const Drawing left = words.drawn("F+F+F+F"), right = words.drawn("F-F-F-F");
  EXPECT_EQ(total_length(left), 4.0);
  EXPECT_EQ(signed_area(left), 1.0);
  EXPECT_EQ(signed_area(right), -1.0);
  EXPECT_EQ(closing_gap(left), 0.0);
  EXPECT_EQ(segment_box(left).low(), (Vector3{-1, 0, 0}));
  EXPECT_EQ(segment_box(left).high(), (Vector3{0, 1, 0}));
}

TEST(DrawingMeasures, SeeGapsAndOpenLines) {
  TestWords words(test_turtle(90.0));
  EXPECT_EQ(closing_gap(words.drawn("F+F+F")), 1.0);
  EXPECT_TRUE(is_one_line(words.drawn("F+F+F")));
  EXPECT_FALSE(is_one_line(words.drawn("FfF")));
  EXPECT_FALSE(is_one_line(words.drawn("F[+F]F")));
  Drawing almost = words.drawn("FF");
  almost.segments[1].from.y = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(is_one_line(almost));
}

TEST(DrawingMeasures, AreaDoesNotDependOnThePlace) {
  TestWords words(test_turtle(90.0));
  EXPECT_EQ(signed_area(words.drawn("f(1000000)+f(77)F(3)+F(2)+F(3)+F(2)")), 6.0);
}

TEST(DrawingMeasures, CountSegmentsWithoutTheirDirection) {
  const Vector3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0};
  const DistinctParts parts = distinct_parts(of({{a, b}, {b, a}, {b, c}, {a, b}}));
  EXPECT_EQ(parts.segments, 2u);
  EXPECT_EQ(parts.most_often, 3u);
  EXPECT_EQ(parts.vertices, 3u);
}

TEST(DrawingMeasures, CountExactlyOrWithATolerance) {
  const Vector3 a{0, 0, 0}, b{1, 0, 0}, near_b{1 + 1e-12, -1e-12, 0};
  const Drawing twice = of({{a, b}, {near_b, a}});
  EXPECT_EQ(distinct_parts(twice).segments, 2u);
  EXPECT_EQ(distinct_parts(twice).vertices, 3u);
  EXPECT_EQ(distinct_parts(twice, 1e-9).segments, 1u);
  EXPECT_EQ(distinct_parts(twice, 1e-9).most_often, 2u);
  EXPECT_EQ(distinct_parts(twice, 1e-9).vertices, 2u);
  EXPECT_EQ(distinct_parts(twice, 1e-13).vertices, 3u);
}

TEST(DrawingMeasures, ZeroHasNoSign) {
  const std::vector<Vector3> points{{0.0, -0.0, 0.0}, {-0.0, 0.0, -0.0}};
  EXPECT_EQ(distinct_point_count(points), 1u);
}

TEST(DrawingMeasures, VectorAreaKnowsTheSide) {
  const std::vector<Vector3> triangle{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}};
  EXPECT_EQ(vector_area(triangle), (Vector3{0, 0, 2}));
  const std::vector<Vector3> other_way{triangle.rbegin(), triangle.rend()};
  EXPECT_EQ(vector_area(other_way), (Vector3{0, 0, -2}));
  EXPECT_EQ(vector_area(std::vector<Vector3>{{1, 2, 3}, {3, 4, 5}}), Vector3{});
}

TEST(DrawingMeasures, OfATree) {
  const Skeleton tree = TestWords(test_turtle(90.0)).tree("F(2)[+F][-F(3)]F(4)").skeleton;
  EXPECT_EQ(child_counts(tree), (std::map<std::size_t, std::size_t>{{0, 3}, {1, 1}, {3, 1}}));
  EXPECT_EQ(path_lengths(tree), (std::vector<double>{0, 2, 3, 5, 6}));
  EXPECT_EQ(tip_positions(tree), (std::vector<Vector3>{{-1, 2, 0}, {3, 2, 0}, {0, 6, 0}}));
  EXPECT_TRUE(tip_positions(Skeleton{Vector3{}}).empty());
}

}  // namespace
}  // namespace phytobench
