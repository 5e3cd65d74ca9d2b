// SPDX-License-Identifier: MIT
#include "core/point_pattern/edge_correction.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

constexpr double pi = std::numbers::pi;
constexpr double circle_share_rounding = 1e-12;

TEST(ShareOfCircleInside, IsTheOneByHand) {
  const Window square = Window::rectangle({{-1.0, -1.0}, {1.0, 1.0}});
  for (const Window& window : {square, Window::polygon(square.corners())}) {
    EXPECT_EQ(share_of_circle_inside(window, {0.0, 0.0}, 0.0), 1.0);
    EXPECT_NEAR(share_of_circle_inside(window, {0.0, 0.0}, 0.75), 1.0, circle_share_rounding);
    EXPECT_NEAR(share_of_circle_inside(window, {1.0, 0.0}, 0.5), 0.5,
                circle_share_rounding);  // on a side
    EXPECT_NEAR(share_of_circle_inside(window, {1.0, -1.0}, 1.5), 0.25,
                circle_share_rounding);  // on a corner
    // Side at half the radius: a third outside. All four sides: 8 arcs of acos(1/r) outside.
    EXPECT_NEAR(share_of_circle_inside(window, {0.5, 0.0}, 1.0), 2.0 / 3.0, circle_share_rounding);
    EXPECT_NEAR(share_of_circle_inside(window, {0.0, 0.0}, 1.25), 1.0 - 4.0 * std::acos(0.8) / pi,
                circle_share_rounding);
    EXPECT_NEAR(share_of_circle_inside(window, {0.0, 0.0}, 1.5), 0.0, circle_share_rounding);
    EXPECT_NEAR(share_of_circle_inside(window, {0.0, 0.0}, 100.0), 0.0, circle_share_rounding);
  }
  EXPECT_NEAR(share_of_circle_inside(l_shape(), {1.0, 1.0}, 0.5), 0.75, circle_share_rounding);
  EXPECT_NEAR(share_of_circle_inside(l_shape(), {0.5, 0.5}, 0.5), 1.0, circle_share_rounding);
  EXPECT_EQ(share_of_circle_inside(Window::torus(unit_square), {0.1, 0.1}, 0.3), 1.0);
}

// Two independent ways: sides with overlapping corners, and arcs between sorted cuts.
TEST(ShareOfCircleInsideOracle, OfARectangleIsThatOfThePolygon) {
  const Window plot = Window::rectangle({{2.0, -1.0}, {5.0, 1.0}});
  const Window polygon = Window::polygon(plot.corners());
  CounterStream stream(51, 0);
  for (int i = 0; i < 3000; ++i) {
    const Point2 centre = plot.random_point(stream);
    const double radius = stream.next_between(0.0, 3.5);
    EXPECT_NEAR(share_of_circle_inside(plot, centre, radius),
                share_of_circle_inside(polygon, centre, radius), 1e-9);
  }
}

TEST(ShareOfCircleInsideOracle, OfThePolygonIsThatOfManyPoints) {
  constexpr int directions = 20000;
  CounterStream stream(52, 0);
  for (int i = 0; i < 30; ++i) {
    const Point2 centre = l_shape().random_point(stream);
    const double radius = stream.next_between(0.0, 1.5);
    int inside = 0;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / directions;
      inside += l_shape().contains(centre + radius * Point2{std::cos(angle), std::sin(angle)});
    }
    // At most 12 cuts, each off by one direction.
    EXPECT_NEAR(share_of_circle_inside(l_shape(), centre, radius),
                static_cast<double>(inside) / directions, 12.0 / directions);
  }
}

TEST(PairWeights, AreThoseOfTheirDefinition) {
  const Window plot = Window::rectangle({{0.0, 0.0}, {4.0, 2.0}});
  const Points points{{0.0, 0.0}, {2.0, 1.0}};
  const Point2 d{1.0, -0.5};
  EXPECT_EQ(PairWeights(points, plot, EdgeCorrection::none)(0, d, 1.0), 1.0);
  EXPECT_EQ(PairWeights(points, plot, EdgeCorrection::translation)(0, d, 1.0), 8.0 / (3.0 * 1.5));
  const PairWeights isotropic(points, plot, EdgeCorrection::isotropic);
  EXPECT_NEAR(isotropic(0, d, 1.0), 4.0, circle_share_rounding);
  EXPECT_EQ(isotropic(1, d, 1.0), 1.0);
  EXPECT_NEAR(isotropic(1, d, 2.0), 1.0 / (1.0 - 2.0 / 3.0), circle_share_rounding);
  EXPECT_EQ(isotropic(1, d, std::sqrt(5.0)), 0.0);  // through the corners
}

TEST(EdgeCorrection, IsDefinedWhereItHasAMeaning) {
  for (const WindowKind kind : {WindowKind::rectangle, WindowKind::polygon, WindowKind::torus})
    EXPECT_TRUE(is_defined(usual_correction(kind), kind));
  EXPECT_FALSE(is_defined(EdgeCorrection::none, WindowKind::torus));
  EXPECT_FALSE(is_defined(EdgeCorrection::torus, WindowKind::rectangle));
  EXPECT_FALSE(is_defined(EdgeCorrection::translation, WindowKind::polygon));
  EXPECT_TRUE(is_defined(EdgeCorrection::border, WindowKind::polygon));
  EXPECT_EQ(name_of(EdgeCorrection::isotropic), "isotropic");
  EXPECT_THROW(PairWeights({}, l_shape(), EdgeCorrection::translation), ContractViolation);
  EXPECT_THROW(PairWeights({}, l_shape(), EdgeCorrection::border), ContractViolation);
  EXPECT_THROW(PairWeights(Points{{1.5, 1.5}}, l_shape(), EdgeCorrection::isotropic),
               ContractViolation);
  EXPECT_THROW(share_of_circle_inside(l_shape(), {1.5, 1.5}, 0.1), ContractViolation);
}

}  // namespace
}  // namespace phytobench
