// SPDX-License-Identifier: MIT
// A point on the ground, and the rectangle that most plots are.
#pragma once

#include <cmath>

namespace phytobench {

struct Point2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Point2&, const Point2&) = default;
};

constexpr Point2 operator+(const Point2& a, const Point2& b) {
  return {a.x + b.x, a.y + b.y};
}

constexpr Point2 operator-(const Point2& a, const Point2& b) {
  return {a.x - b.x, a.y - b.y};
}

constexpr Point2 operator*(double factor, const Point2& p) {
  return {factor * p.x, factor * p.y};
}

constexpr double dot(const Point2& a, const Point2& b) {
  return a.x * b.x + a.y * b.y;
}

/// Twice the signed area of the triangle (0, a, b): positive if b lies to the left of a.
constexpr double cross(const Point2& a, const Point2& b) {
  return a.x * b.y - a.y * b.x;
}

constexpr double squared_norm(const Point2& p) {
  return dot(p, p);
}

inline double norm(const Point2& p) {
  return std::sqrt(squared_norm(p));
}

/// Axis-parallel; `low` is its lower left corner. Both sides are longer than 0 wherever one is
/// asked for.
struct Rectangle {
  Point2 low;
  Point2 high;

  constexpr double width() const { return high.x - low.x; }
  constexpr double height() const { return high.y - low.y; }
  constexpr double area() const { return width() * height(); }
  constexpr double perimeter() const { return 2.0 * (width() + height()); }
  /// The border belongs to it.
  constexpr bool contains(const Point2& p) const {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }

  friend constexpr bool operator==(const Rectangle&, const Rectangle&) = default;
};

}  // namespace phytobench
