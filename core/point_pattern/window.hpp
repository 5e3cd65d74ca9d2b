// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

enum class WindowKind {
  rectangle,  ///< with edges: what lies beyond is unknown
  polygon,    ///< the same, of any simple shape
  torus,      ///< a rectangle whose opposite sides are joined: no edge, distances go round
};

std::string_view name_of(WindowKind kind);

/// The part of the ground in which all points of a pattern were recorded. Without it no statement
/// on a pattern has a meaning: it gives the density, and tells a gap from the end of the plot.
class Window {
 public:
  /// Both sides must be finite and longer than 0; ContractViolation otherwise.
  static Window rectangle(const Rectangle& rectangle);
  static Window torus(const Rectangle& rectangle);

  /// At least three corners in either order, the last joined to the first; the first may
  /// stand there again at the end. Throws InputError if
  /// a corner is not finite or the same as the next, sides cross or touch, or the area is 0.
  static Window polygon(std::vector<Point2> corners);

  WindowKind kind() const { return kind_; }
  double area() const { return area_; }
  double perimeter() const { return perimeter_; }  ///< of a torus: that of its rectangle
  const Rectangle& bounding_box() const { return box_; }
  /// Counter-clockwise; the four corners of the box for the other kinds.
  const std::vector<Point2>& corners() const { return corners_; }

  /// The border belongs to the window.
  bool contains(const Point2& point) const;

  /// Uniform in the window; two numbers of the stream per try, one try in a rectangle.
  Point2 random_point(UnitStream& stream) const;

  /// The same place inside a torus, from however far outside; the point itself for other windows.
  Point2 wrapped(const Point2& point) const;

  /// b - a, on a torus the shortest of its images.
  Point2 difference(const Point2& a, const Point2& b) const {
    Point2 d = b - a;
    if (kind_ == WindowKind::torus) {
      d.x = shortest(d.x, box_.width());
      d.y = shortest(d.y, box_.height());
    }
    return d;
  }

 private:
  Window(WindowKind kind, const Rectangle& box, std::vector<Point2> corners);

  static double shortest(double d, double period) {
    return 2.0 * d > period ? d - period : 2.0 * d < -period ? d + period : d;
  }

  WindowKind kind_;
  Rectangle box_;
  std::vector<Point2> corners_;
  double area_ = 0.0;
  double perimeter_ = 0.0;
};

}  // namespace phytobench
