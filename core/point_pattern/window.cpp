// SPDX-License-Identifier: MIT
#include "core/point_pattern/window.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

std::vector<Point2> corners_of(const Rectangle& r) {
  return {r.low, {r.high.x, r.low.y}, r.high, {r.low.x, r.high.y}};
}

double signed_area(const std::vector<Point2>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return 0.5 * twice;
}

/// On which side of the line through a and b the point lies: 1, 0 or -1.
int side(const Point2& a, const Point2& b, const Point2& p) {
  const double twice = cross(b - a, p - a);
  return twice > 0.0 ? 1 : twice < 0.0 ? -1 : 0;
}

bool is_between(const Point2& a, const Point2& b, const Point2& p) {
  return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
  return is_between(a, b, c) || is_between(a, b, d) || is_between(c, d, a) || is_between(c, d, b);
}

/// Corners as the user numbers them: from 1, in their own order.
void refuse_wrong_corners(const std::vector<Point2>& corners) {
  const std::size_t n = corners.size();
  if (n < 3) throw InputError("a polygon needs at least three corners");
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y))
      throw InputError(fmt::format("corner {} of the polygon is not finite; correct it", i + 1));
    if (corners[i] == corners[(i + 1) % n])
      throw InputError(fmt::format("corners {} and {} of the polygon are the same; remove one",
                                   i + 1, (i + 1) % n + 1));
  }
}

void refuse_crossing_sides(const std::vector<Point2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      if (meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n]))
        throw InputError(fmt::format(
            "sides {} and {} of the polygon meet; give the corners of a simple polygon in order",
            i + 1, j + 1));
    }
  }
}

Rectangle box_of(const std::vector<Point2>& corners) {
  Rectangle box{corners[0], corners[0]};
  for (const Point2& p : corners) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

void expect_sides(const Rectangle& r) {
  PHYTOBENCH_EXPECT(std::isfinite(r.area()) && r.width() > 0.0 && r.height() > 0.0);
}

}  // namespace

std::string_view name_of(WindowKind kind) {
  switch (kind) {
    case WindowKind::rectangle:
      return "rectangle";
    case WindowKind::polygon:
      return "polygon";
    case WindowKind::torus:
      return "torus";
  }
  return "";
}

Window::Window(WindowKind kind, const Rectangle& box, std::vector<Point2> corners)
    : kind_(kind), box_(box), corners_(std::move(corners)), area_(signed_area(corners_)) {
  for (std::size_t i = 0; i < corners_.size(); ++i)
    perimeter_ += norm(corners_[(i + 1) % corners_.size()] - corners_[i]);
}

Window Window::rectangle(const Rectangle& rectangle) {
  expect_sides(rectangle);
  return {WindowKind::rectangle, rectangle, corners_of(rectangle)};
}

Window Window::torus(const Rectangle& rectangle) {
  expect_sides(rectangle);
  return {WindowKind::torus, rectangle, corners_of(rectangle)};
}

Window Window::polygon(std::vector<Point2> corners) {
  // Maps close a ring by its first corner.
  if (corners.size() > 3 && corners.front() == corners.back()) corners.pop_back();
  refuse_wrong_corners(corners);
  refuse_crossing_sides(corners);
  const double area = signed_area(corners);
  if (area == 0.0) throw InputError("the polygon's area is 0; give corners that are not in line");
  if (area < 0.0) std::reverse(corners.begin(), corners.end());
  const Rectangle box = box_of(corners);
  return {WindowKind::polygon, box, std::move(corners)};
}

bool Window::contains(const Point2& point) const {
  if (!box_.contains(point)) return false;
  if (kind_ != WindowKind::polygon) return true;
  bool inside = false;
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const Point2 &a = corners_[j], &b = corners_[i];
    if (is_between(a, b, point)) return true;
    // A side counts if it reaches from below the point's height to it or above.
    if ((a.y > point.y) != (b.y > point.y) && side(a, b, point) == (b.y > a.y ? 1 : -1))
      inside = !inside;
  }
  return inside;
}

Point2 Window::wrapped(const Point2& point) const {
  if (kind_ != WindowKind::torus) return point;
  const auto wrap = [](double value, double low, double high) {
    const double periods =
        value < low || value > high ? std::floor((value - low) / (high - low)) : 0.0;
    // Rounding may leave it a little outside.
    return std::clamp(value - periods * (high - low), low, high);
  };
  return {wrap(point.x, box_.low.x, box_.high.x), wrap(point.y, box_.low.y, box_.high.y)};
}

Point2 Window::random_point(UnitStream& stream) const {
  for (;;) {
    const double x = stream.next_between(box_.low.x, box_.high.x);
    const Point2 p{x, stream.next_between(box_.low.y, box_.high.y)};
    if (kind_ != WindowKind::polygon || contains(p)) return p;
  }
}

}  // namespace phytobench
