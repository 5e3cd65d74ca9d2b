// SPDX-License-Identifier: MIT
#include "core/point_pattern/edge_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/point_pattern/edge_distance.hpp"

namespace phytobench {

namespace {

constexpr double pi = std::numbers::pi;

/// Each side that is nearer than the radius cuts off an arc. Arcs of neighbouring sides overlap if
/// their corner lies in the circle; those of opposite sides never do.
double share_in_rectangle(const Rectangle& box, const Point2& centre, double radius) {
  const std::array<double, 4> gaps{box.high.x - centre.x, box.high.y - centre.y,
                                   centre.x - box.low.x, centre.y - box.low.y};
  std::array<double, 4> half_arcs{};
  for (std::size_t side = 0; side < 4; ++side)
    if (gaps[side] < radius) half_arcs[side] = std::acos(std::max(0.0, gaps[side]) / radius);
  double outside = 0.0;
  for (std::size_t side = 0; side < 4; ++side) {
    const double shared = half_arcs[side] + half_arcs[(side + 1) % 4] - 0.5 * pi;
    outside += 2.0 * half_arcs[side] - std::max(0.0, shared);
  }
  return std::max(0.0, 1.0 - outside / (2.0 * pi));
}

/// Appends the directions from the centre to where the circle meets the side from a to b.
void add_crossings(const Point2& a, const Point2& b, double radius, std::vector<double>& angles) {
  // |a + t (b - a)|^2 = radius^2, a and b relative to the centre.
  const Point2 along = b - a;
  const double length = squared_norm(along), middle = -dot(a, along) / length;
  const double root = (radius * radius - squared_norm(a + middle * along)) / length;
  if (root < 0.0) return;
  for (const double t : {middle - std::sqrt(root), middle + std::sqrt(root)}) {
    // Cuts a little beyond the corners do no harm; missing one at a corner would.
    if (t < -1e-9 || t > 1.0 + 1e-9) continue;
    const Point2 cut = a + t * along;
    angles.push_back(std::atan2(cut.y, cut.x));
  }
}

double share_in_polygon(const Window& window, const Point2& centre, double radius) {
  const std::vector<Point2>& corners = window.corners();
  std::vector<double> angles;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
    add_crossings(corners[j] - centre, corners[i] - centre, radius, angles);
  const auto is_inside = [&](double angle) {
    return window.contains(centre + radius * Point2{std::cos(angle), std::sin(angle)});
  };
  if (angles.empty()) return is_inside(0.0) ? 1.0 : 0.0;
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2.0 * pi);

  // Between two cuts an arc is either inside or outside, and its middle tells.
  double inside = 0.0;
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (angles[i] > angles[i - 1] && is_inside(0.5 * (angles[i - 1] + angles[i])))
      inside += angles[i] - angles[i - 1];
  return inside / (2.0 * pi);
}

}  // namespace

std::string_view name_of(EdgeCorrection correction) {
  switch (correction) {
    case EdgeCorrection::none:
      return "none";
    case EdgeCorrection::border:
      return "border";
    case EdgeCorrection::translation:
      return "translation";
    case EdgeCorrection::isotropic:
      return "isotropic";
    case EdgeCorrection::torus:
      return "torus";
  }
  return "";
}

bool is_defined(EdgeCorrection correction, WindowKind window) {
  if (window == WindowKind::torus || correction == EdgeCorrection::torus)
    return window == WindowKind::torus && correction == EdgeCorrection::torus;
  return correction != EdgeCorrection::translation || window == WindowKind::rectangle;
}

EdgeCorrection usual_correction(WindowKind window) {
  switch (window) {
    case WindowKind::rectangle:
      return EdgeCorrection::translation;
    case WindowKind::polygon:
      return EdgeCorrection::isotropic;
    case WindowKind::torus:
      break;
  }
  return EdgeCorrection::torus;
}

double share_of_circle_inside(const Window& window, const Point2& centre, double radius) {
  PHYTOBENCH_EXPECT(window.contains(centre) && std::isfinite(radius) && radius >= 0.0);
  if (radius == 0.0 || window.kind() == WindowKind::torus) return 1.0;
  return window.kind() == WindowKind::rectangle
             ? share_in_rectangle(window.bounding_box(), centre, radius)
             : share_in_polygon(window, centre, radius);
}

PairWeights::PairWeights(std::span<const Point2> points, const Window& window,
                         EdgeCorrection correction)
    : window_(window),
      correction_(correction),
      all_one_(correction == EdgeCorrection::none || correction == EdgeCorrection::torus) {
  PHYTOBENCH_EXPECT(is_defined(correction, window.kind()));
  PHYTOBENCH_EXPECT(correction != EdgeCorrection::border);
  if (correction != EdgeCorrection::isotropic) return;
  for (const Point2& point : points) PHYTOBENCH_EXPECT(window.contains(point));
  points_.assign(points.begin(), points.end());
  to_edge_ = distances_to_edge(window, points);
}

double PairWeights::operator()(std::size_t first, const Point2& difference, double distance) const {
  if (all_one_) return 1.0;
  if (correction_ == EdgeCorrection::translation) {
    const Rectangle& box = window_.bounding_box();
    const double overlap =
        (box.width() - std::abs(difference.x)) * (box.height() - std::abs(difference.y));
    return overlap > 0.0 ? box.area() / overlap : 0.0;
  }
  if (distance <= to_edge_[first]) return 1.0;
  const double share = window_.kind() == WindowKind::rectangle
                           ? share_in_rectangle(window_.bounding_box(), points_[first], distance)
                           : share_in_polygon(window_, points_[first], distance);
  // Below this the arcs are no longer than their rounding errors.
  constexpr double least_share = 1e-9;
  return share > least_share ? 1.0 / share : 0.0;
}

}  // namespace phytobench
