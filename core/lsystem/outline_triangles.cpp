// SPDX-License-Identifier: MIT
#include "core/lsystem/outline_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/geometry/point2.hpp"
#include "core/geometry/rotation.hpp"
#include "core/lsystem/drawing_measures.hpp"

namespace phytobench {

namespace {

/// Whether the outline only goes to b and comes back the same way.
bool is_spike(const Vector3& a, const Vector3& b, const Vector3& c, double tolerance) {
  const Vector3 there = b - a, back = c - b;
  return dot(there, back) < 0.0 &&
         norm(cross(there, back)) <= tolerance * std::max(norm(there), norm(back));
}

/// Without corners that lie on the one before, up to rounding, and without spikes; the last corner
/// is before the first.
std::vector<Vector3> cleaned(std::span<const Vector3> outline, double tolerance) {
  std::vector<Vector3> corners;
  const auto is_repeat = [&](const Vector3& a, const Vector3& b) {
    return norm(a - b) <= tolerance;
  };
  for (const Vector3& corner : outline) {
    while (corners.size() >= 2 &&
           is_spike(corners[corners.size() - 2], corners.back(), corner, tolerance))
      corners.pop_back();
    if (corners.empty() || !is_repeat(corners.back(), corner)) corners.push_back(corner);
  }
  while (corners.size() > 2) {
    const Vector3 &last = corners.back(), &first = corners.front();
    if (is_repeat(last, first) || is_spike(corners[corners.size() - 2], last, first, tolerance))
      corners.pop_back();
    else if (is_spike(last, first, corners[1], tolerance))
      corners.erase(corners.begin());
    else
      break;
  }
  return corners;
}

/// Twice the area of a triangle, positive if it runs counter-clockwise.
double twice_area(const Point2& a, const Point2& b, const Point2& c) {
  return cross(b - a, c - a);
}

/// An outline that loses corner after corner.
class EarClipper {
 public:
  /// Triangles of no more than `flat`, twice their area, are left out.
  EarClipper(const std::vector<Point2>& points, double flat) : points_(points), flat_(flat) {
    for (std::uint32_t i = 0; i < points.size(); ++i) left_.push_back(i);
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::size_t at = 0, tried = 0;
    while (left_.size() > 3) {
      at %= left_.size();
      const bool is_stuck = tried == left_.size();  // it crosses itself
      if (!is_stuck && !is_ear(at)) {
        ++at;
        ++tried;
        continue;
      }
      cut(at);
      tried = 0;
    }
    cut(0);
    return std::move(triangles_);
  }

 private:
  std::array<std::uint32_t, 3> around(std::size_t at) const {
    const std::size_t count = left_.size();
    return {left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]};
  }

  bool is_ear(std::size_t at) const {
    const auto [before, here, after] = around(at);
    const Point2 &a = points_[before], &b = points_[here], &c = points_[after];
    const double area = twice_area(a, b, c);
    if (area < -flat_) return false;
    if (area <= flat_) return true;  // on a straight edge: nothing is lost with it
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t other) {
      const Point2& p = points_[other];
      if (p == a || p == b || p == c) return false;
      return twice_area(a, b, p) >= 0.0 && twice_area(b, c, p) >= 0.0 && twice_area(c, a, p) >= 0.0;
    });
  }

  void cut(std::size_t at) {
    const auto [before, here, after] = around(at);
    if (twice_area(points_[before], points_[here], points_[after]) > flat_)
      triangles_.push_back({before, here, after});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  const std::vector<Point2>& points_;
  double flat_;
  std::vector<std::uint32_t> left_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

OutlineTriangles outline_triangles(std::span<const Vector3> outline) {
  PHYTOBENCH_EXPECT(outline.size() <= most_outline_corners);
  BoundingBox box;
  for (const Vector3& corner : outline) box.extend(corner);
  const double size = norm(box.extent());
  constexpr double rounding = 1e-9;
  OutlineTriangles filled;
  filled.corners = cleaned(outline, rounding * size);
  const Vector3 area = vector_area(filled.corners);
  if (filled.corners.size() < 3 || !(norm(area) > rounding * size * size)) return filled;
  filled.normal = area / norm(area);
  filled.across = any_perpendicular(filled.normal);
  const Vector3 along = cross(filled.normal, filled.across);
  std::vector<Point2> points;
  for (const Vector3& corner : filled.corners) {
    const Vector3 offset = corner - filled.corners.front();
    points.push_back({dot(offset, filled.across), dot(offset, along)});
  }
  constexpr double flat = 1e-12;
  filled.triangles = EarClipper(points, flat * size * size).run();
  return filled;
}

}  // namespace phytobench
