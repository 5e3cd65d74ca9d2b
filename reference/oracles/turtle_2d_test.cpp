// SPDX-License-Identifier: MIT
#include "reference/oracles/turtle_2d.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/brzoska2019_l_systems.hpp"
#include "reference/oracles/drawing_measures.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::oracles {
namespace {

using liebemann2017::derive_in_parallel;

ParametricWord island(int n) {
  return modules_of(derive_in_parallel(liebemann2017::equation_2_6(), n));
}

template <class Point>
void expect_box(const Box<Point>& box, double x0, double x1, double y0, double y1) {
  EXPECT_NEAR(box.least.x, x0, 1e-6);
  EXPECT_NEAR(box.greatest.x, x1, 1e-6);
  EXPECT_NEAR(box.least.y, y0, 1e-6);
  EXPECT_NEAR(box.greatest.y, y1, 1e-6);
}

TEST(LiteralPlaneTurtleLaw, TurnsAreRotationsAndUndoEachOther) {
  for (const double d : {10.0, 22.5, 90.0, 137.5, 180.0, 400.0}) {
    PlaneTurtle turtle;
    turtle.turn("+", d);
    EXPECT_NEAR(turtle.H.x, -std::sin(d * std::numbers::pi / 180), 1e-15);  // left of +y is -x
    EXPECT_NEAR(std::hypot(turtle.H.x, turtle.H.y), 1, 1e-15);
    turtle.turn("-", d);
    EXPECT_NEAR(turtle.H.x, 0, 1e-15);
    EXPECT_NEAR(turtle.H.y, 1, 1e-15);
  }
}

TEST(LiteralPlaneTurtleLaw, AgreesWithTheTurtleOnTheGrid) {
  const ParametricWord word = modules_of("F+FF-[F|f+F]{F-f-F}F+");
  const PlaneDrawing plane = turtle_2d(word, {2, 90});
  const GridDrawing grid = turtle_on_grid(word, {2, 90});
  ASSERT_EQ(plane.nodes.size(), grid.nodes.size());
  EXPECT_EQ(plane.parents, grid.parents);
  for (std::size_t i = 0; i < plane.nodes.size(); ++i) {
    EXPECT_NEAR(plane.nodes[i].x, static_cast<double>(grid.nodes[i].x), 1e-12);
    EXPECT_NEAR(plane.nodes[i].y, static_cast<double>(grid.nodes[i].y), 1e-12);
  }
  EXPECT_EQ(plane.polygons.size(), 1u);
  EXPECT_EQ(plane.polygons[0].size(), 4u);
}

TEST(LiteralPlaneTurtleLaw, ABranchLeavesTheStateAsItWas) {
  const PlaneDrawing with = turtle_2d(modules_of("F+F[-F+F[|F]]"), {3, 25});
  const PlaneDrawing without = turtle_2d(modules_of("F+F"), {3, 25});
  EXPECT_EQ(with.end.position, without.end.position);  // every bit
  EXPECT_EQ(with.end.H, without.end.H);
  EXPECT_EQ(with.segments.size(), 5u);
  // No line is drawn at ].
  const PlaneDrawing next = turtle_2d(modules_of("F[+F]F"), {1, 90});
  EXPECT_EQ(next.segments[2].from, next.segments[0].to);
  EXPECT_EQ(next.parents, (std::vector<int>{-1, 0, 1, 1}));
}

TEST(LiteralPlaneTurtle, RefusesWhatDoesNotMatch) {
  for (const char* word : {"F]", "[F", "{F", "F}", "{F{F}}", "[F]]"})
    EXPECT_THROW(turtle_2d(modules_of(word), {}), std::invalid_argument) << word;
  EXPECT_THROW(turtle_on_grid(modules_of("F"), {0.5, 90}), std::invalid_argument);
  EXPECT_THROW(turtle_on_grid(modules_of("F+"), {1, 45}), std::invalid_argument);
}

TEST(LiteralPlaneTurtle, TakesParametersAndOtherLetters) {
  const PlaneDrawing drawing =
      turtle_2d({{"F", {2}}, {"+", {90}}, {"f", {}}, {"X", {7}}, {"G", {}}}, {3, 10, "FG", "f"});
  EXPECT_NEAR(drawing.end.position.x, -6, 1e-12);
  EXPECT_NEAR(drawing.end.position.y, 2, 1e-12);
  EXPECT_EQ(drawing.segments.size(), 2u);
}

TEST(KochIsland, IsClosedClockwiseAndOfConstantArea) {
  for (int n = 0; n <= 4; ++n) {
    const GridDrawing drawing = turtle_on_grid(island(n), {1, 90});
    EXPECT_EQ(drawing.segments.size(), equation_2_6_F(n));
    EXPECT_TRUE(is_closed(drawing));
    // In steps of 400 / 4^n: 160000 in all.
    const auto side = static_cast<std::int64_t>(whole_power(4, n));
    EXPECT_EQ(twice_signed_area(drawing.nodes), -2 * side * side);
    const auto overhang = static_cast<std::int64_t>(equation_2_6_overhang(n));
    const Box<GridPoint> box = bounding_box(drawing.nodes);
    EXPECT_EQ(box.least, (GridPoint{-overhang, -overhang}));
    EXPECT_EQ(box.greatest, (GridPoint{side + overhang, side + overhang}));
    EXPECT_EQ(distinct_points(drawing.nodes), equation_2_6_F(n));
    for (const int times : segment_repetitions(drawing)) EXPECT_EQ(times, 1);
  }
}

TEST(KochIsland, HasTheLengthsAndBoxesOfFigure24) {
  const double l[] = {400, 100, 25, 6.25}, least[] = {0, -100, -125, -131.25};
  for (int n = 0; n <= 3; ++n) {
    const PlaneDrawing drawing = turtle_2d(island(n), {l[n], 90});
    EXPECT_NEAR(drawn_length(drawing), equation_2_6_drawn_length(n), 1e-7);
    EXPECT_NEAR(twice_signed_area(drawing.nodes) / 2, -160000, 1e-6);
    expect_box(bounding_box(drawing.nodes), least[n], 400 - least[n], least[n], 400 - least[n]);
  }
}

TEST(KochIsland, WouldBeSeenToBeOpenOrDrawnTwice) {
  EXPECT_FALSE(is_closed(turtle_on_grid(modules_of("F-F-F-"), {1, 90})));
  EXPECT_EQ(segment_repetitions(turtle_on_grid(modules_of("F|F"), {1, 90})), std::vector<int>{2});
  EXPECT_EQ(twice_signed_area(turtle_on_grid(modules_of("F+F+F+F"), {1, 90}).nodes), 2);
}

TEST(PlanePlants, HaveTheBoxesOfFigure25) {
  const PlaneDrawing a =
      turtle_2d(modules_of(derive_in_parallel(liebemann2017::figure_2_5a(), 4)), {18, 25});
  expect_box(bounding_box(a.nodes), -217.145753, 452.624431, 0, 985.742483);
  const PlaneDrawing b =
      turtle_2d(modules_of(derive_in_parallel(liebemann2017::figure_2_5b(), 5)), {15, 25});
  expect_box(bounding_box(b.nodes), -295.625614, 223.074191, 0, 945);
}

TEST(PlanePlants, HaveTheBoxOfBrzoskasEquation6) {
  const std::string word = brzoska2019::derive(brzoska2019::equation_6_corrected(), 7);
  const PlaneDrawing drawing = turtle_2d(modules_of(word), {1, 10});
  EXPECT_EQ(drawing.segments.size(), equation_6_F(7));
  expect_box(bounding_box(drawing.nodes), -247.517668, 234.787917, 0, 631.156362);
}

TEST(KochCurve, EndsThreeToTheNFromItsStart) {
  for (int n = 0; n <= 6; ++n) {
    const std::string word = brzoska2019::derive(brzoska2019::equation_5(), n);
    const PlaneDrawing drawing = turtle_2d(modules_of(word), {1, 60});
    EXPECT_NEAR(drawing.end.position.x, 0, 1e-9);
    EXPECT_NEAR(drawing.end.position.y, static_cast<double>(equation_5_end(n)), 1e-9);
  }
}

}  // namespace
}  // namespace phytobench::oracles
