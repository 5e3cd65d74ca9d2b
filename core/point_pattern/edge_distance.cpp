// SPDX-License-Identifier: MIT
#include "core/point_pattern/edge_distance.hpp"

#include <algorithm>
#include <cmath>

#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

double squared_distance_to_side(const Point2& a, const Point2& b, const Point2& point) {
  const Point2 along = b - a, offset = point - a;
  const double share = std::clamp(dot(offset, along) / squared_norm(along), 0.0, 1.0);
  return squared_norm(offset - share * along);
}

}  // namespace

double distance_to_edge(const Window& window, const Point2& point) {
  if (window.kind() == WindowKind::torus) return infinite_distance;
  const Rectangle& box = window.bounding_box();
  if (window.kind() == WindowKind::rectangle && box.contains(point))
    // Without a rounding error, where a pattern lies on a lattice.
    return std::min(
        {point.x - box.low.x, box.high.x - point.x, point.y - box.low.y, box.high.y - point.y});
  const std::vector<Point2>& corners = window.corners();
  double least = infinite_distance;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
    least = std::min(least, squared_distance_to_side(corners[j], corners[i], point));
  return std::sqrt(least);
}

std::vector<double> distances_to_edge(const Window& window, std::span<const Point2> points) {
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Point2& point : points) distances.push_back(distance_to_edge(window, point));
  return distances;
}

}  // namespace phytobench
