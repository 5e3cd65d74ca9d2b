// SPDX-License-Identifier: MIT
#include "core/point_pattern/edge_distance.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

TEST(DistanceToEdge, IsTheNearestSideOrCorner) {
  const Window plot = Window::rectangle({{-1.0, 0.0}, {3.0, 2.0}});
  EXPECT_EQ(distance_to_edge(plot, {1.0, 1.0}), 1.0);
  EXPECT_EQ(distance_to_edge(plot, {-0.75, 1.0}), 0.25);
  EXPECT_EQ(distance_to_edge(plot, {2.5, 1.0}), 0.5);
  EXPECT_EQ(distance_to_edge(plot, {1.0, 1.875}), 0.125);
  EXPECT_EQ(distance_to_edge(plot, {6.0, 6.0}), 5.0);  // from outside
  EXPECT_EQ(distance_to_edge(l_shape(), {0.5, 0.5}), 0.5);
  EXPECT_EQ(distance_to_edge(l_shape(), {0.75, 0.75}), std::sqrt(0.125));  // the inner corner
  EXPECT_EQ(distance_to_edge(l_shape(), {1.5, 1.5}), 0.5);
}

TEST(DistanceToEdge, IsZeroOnTheBorderAndInfiniteWithoutOne) {
  for (const Window& window : {Window::rectangle(unit_square), l_shape()})
    for (const Point2& corner : window.corners()) EXPECT_EQ(distance_to_edge(window, corner), 0.0);
  EXPECT_EQ(distance_to_edge(l_shape(), {1.0, 1.5}), 0.0);
  EXPECT_EQ(distance_to_edge(Window::torus(unit_square), {0.0, 0.5}),
            std::numeric_limits<double>::infinity());
}

TEST(DistanceToEdgeOracle, OfARectangleIsThatOfThePolygon) {
  const Window plot = Window::rectangle({{-1.0, 0.0}, {3.0, 2.0}});
  const Window polygon = Window::polygon(plot.corners());
  const Points points = random_points(plot, 500, 1);
  const std::vector<double> distances = distances_to_edge(plot, points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(distances[i], distance_to_edge(polygon, points[i]), 1e-15);
}

}  // namespace
}  // namespace phytobench
