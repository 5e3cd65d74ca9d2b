// SPDX-License-Identifier: MIT
#include "reference/oracles/turtle_3d.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/drawing_measures.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::oracles {
namespace {

constexpr double s = 0.382683432365089771728;  // sin and cos of 22.5 degrees
constexpr double c = 0.923879532511286756128;

void expect_point(SpacePoint p, SpacePoint q, double tolerance = 1e-15) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
  EXPECT_NEAR(p.z, q.z, tolerance);
}

Matrix3 turned(const char* letter, TurtleMatrices matrices, double d_deg = 22.5) {
  SpaceTurtle turtle{{}, start_local, matrices};
  turtle.turn(letter, d_deg);
  return turtle.R;
}

TEST(LiteralSpaceTurtle, TurnsAsTheWordsOfTheTextSay) {
  const Matrix3 left = turned("+", TurtleMatrices::printed);
  expect_point(column(left, 0), {c, s, 0});  // H' = c H + s L
  const Matrix3 down = turned("&", TurtleMatrices::printed);
  expect_point(column(down, 0), {c, 0, -s});  // H' = c H - s U
  const Matrix3 roll = turned("\\", TurtleMatrices::printed);
  expect_point(column(roll, 1), {0, c, -s});  // L' = c L - s U
  expect_point(column(roll, 2), {0, s, c});   // U' = c U + s L: up tips to the left
}

TEST(LiteralSpaceTurtle, TurnsTheOtherWayWithTheMatricesOfAbop) {
  for (const char* letter : {"+", "&", "\\"}) {
    const Matrix3 printed = turned(letter, TurtleMatrices::printed);
    const Matrix3 abop = turned(letter, TurtleMatrices::abop);
    const Matrix3 back = turned(letter, TurtleMatrices::printed, -22.5);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(abop[i][j], printed[j][i]);  // the transpose
        EXPECT_EQ(abop[i][j], back[i][j]);
      }
  }
}

TEST(LiteralSpaceTurtle, ProgramsDifferInPitchAndRoll) {
  EXPECT_EQ(turned("+", TurtleMatrices::cpfg), turned("+", TurtleMatrices::printed));
  EXPECT_EQ(turned("&", TurtleMatrices::cpfg), turned("&", TurtleMatrices::printed));
  EXPECT_EQ(turned("\\", TurtleMatrices::cpfg), turned("/", TurtleMatrices::printed));
  EXPECT_EQ(turned("+", TurtleMatrices::lpfg_uncorrected), turned("+", TurtleMatrices::printed));
  EXPECT_EQ(turned("&", TurtleMatrices::lpfg_uncorrected), turned("^", TurtleMatrices::printed));
  EXPECT_EQ(turned("\\", TurtleMatrices::lpfg_uncorrected), turned("/", TurtleMatrices::printed));
}

TEST(LiteralSpaceTurtleLaw, EveryWordKeepsAFrame) {
  std::string word;
  unsigned number = 1;
  for (int i = 0; i < 20000; ++i) {
    number = number * 1664525u + 1013904223u;
    word += "+-&^\\/|"[(number >> 16) % 7];
  }
  for (const TurtleMatrices matrices : {TurtleMatrices::printed, TurtleMatrices::abop}) {
    const SpaceDrawing drawing = turtle_3d(modules_of(word), {1, 22.5}, start_local, matrices);
    const Matrix3& R = drawing.end.R;
    EXPECT_LT(distance_from_orthonormal(R), 1e-10);
    const SpacePoint H = column(R, 0), L = column(R, 1), U = column(R, 2);
    expect_point({H.y * L.z - H.z * L.y, H.z * L.x - H.x * L.z, H.x * L.y - H.y * L.x}, U, 1e-10);
  }
  Matrix3 skewed = start_local;
  skewed[0][1] = 0.25;
  EXPECT_EQ(distance_from_orthonormal(skewed), 0.25);
}

TEST(LiteralSpaceTurtleLaw, InItsPlaneItIsThePlaneTurtle) {
  const ParametricWord word = modules_of("F+F[-F|F]f--F");
  const SpaceDrawing space = turtle_3d(word, {2, 25}, start_upwards);
  const PlaneDrawing plane = turtle_2d(word, {2, 25});
  ASSERT_EQ(space.nodes.size(), plane.nodes.size());
  for (std::size_t i = 0; i < space.nodes.size(); ++i)
    expect_point(space.nodes[i], {plane.nodes[i].x, plane.nodes[i].y, 0}, 1e-14);
}

TEST(TreeOfEquation217, HasItsBoxes) {
  struct Case {
    double a;
    SpacePoint least, greatest;
  };
  const Case cases[] = {
      {18.95, {0, -1197.108651, -1200.537672}, {2312.732188, 1135.355224, 1460.05989}},
      {36.0, {0, -1524.102902, -1545.308698}, {2135.762593, 1477.325773, 1748.29983}}};
  for (const Case& figure : cases) {
    const SpaceDrawing drawing =
        turtle_3d(derive(liebemann2017::equation_2_17(figure.a, 137.5, 1.3), 8), {});
    const Box<SpacePoint> box = bounding_box(drawing.nodes);
    expect_point(box.least, figure.least, 1e-5);
    expect_point(box.greatest, figure.greatest, 1e-5);
    EXPECT_LT(distance_from_orthonormal(drawing.end.R), 1e-12);
    EXPECT_NEAR(drawn_length(drawing), equation_2_17_drawn_length(8, 1.3), 1e-5);
  }
}

std::vector<SpacePoint> tips(const SpaceDrawing& drawing) {
  std::vector<bool> has_successor(drawing.nodes.size(), false);
  for (const int parent : drawing.parents)
    if (parent >= 0) has_successor[static_cast<std::size_t>(parent)] = true;
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < drawing.nodes.size(); ++i)
    if (!has_successor[i]) points.push_back(drawing.nodes[i]);
  return points;
}

TEST(Bush, HasThreeToTheNTipsWithFiveAndSevenSlashes) {
  const ParametricWord word = modules_of(derive_in_parallel(lintermann1997::bush({}), 5));
  const SpaceDrawing drawing = turtle_3d(word, {1, 22.5});
  EXPECT_EQ(tips(drawing).size(), 243u);
  EXPECT_EQ(distinct_points(tips(drawing)), 243u);
  EXPECT_EQ(segment_repetitions(drawing).size(), 420u);
  EXPECT_EQ(drawing.polygons.size(), 135u);
  const Box<SpacePoint> box = bounding_box(drawing.nodes);
  EXPECT_NEAR(box.greatest.y - box.least.y, 15.16, 0.005);
}

TEST(Bush, FallsIntoAPlaneWithEightSlashes) {
  const ParametricWord word = modules_of(derive_in_parallel(lintermann1997::bush({8, 8, 8, 3}), 5));
  const SpaceDrawing drawing = turtle_3d(word, {1, 22.5});
  EXPECT_EQ(tips(drawing).size(), 243u);
  EXPECT_EQ(distinct_points(tips(drawing)), 32u);
  EXPECT_EQ(segment_repetitions(drawing).size(), 86u);
  const Box<SpacePoint> box = bounding_box(drawing.nodes);
  EXPECT_NEAR(box.greatest.y - box.least.y, 0, 1e-12);
}

TEST(BushLeaf, IsAClosedHexagon) {
  const SpaceDrawing drawing = turtle_3d(modules_of("{-f+f+f-|-f+f+f}"), {1, 22.5});
  ASSERT_EQ(drawing.polygons.size(), 1u);
  const std::vector<SpacePoint>& corners = drawing.polygons[0];
  ASSERT_EQ(corners.size(), 7u);
  EXPECT_LT(length_of(corners.front(), corners.back()), 1e-15);
  EXPECT_EQ(distinct_points(corners), 6u);
  EXPECT_NEAR(std::fabs(twice_signed_area(corners)) / 2, 2 * s + std::sqrt(0.5), 1e-14);
  const Box<SpacePoint> box = bounding_box(corners);
  EXPECT_NEAR(box.greatest.x - box.least.x, 2.8477591, 5e-8);
  EXPECT_NEAR(box.greatest.y - box.least.y, 0.7653669, 5e-8);
}

}  // namespace
}  // namespace phytobench::oracles
