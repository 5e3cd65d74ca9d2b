// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/empty_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Counter-clockwise, seen from the point whose cell it is.
using Corners = std::vector<Point2>;

/// Positive for what is nearer to `other` than to the origin.
double beyond_bisector(const Point2& place, const Point2& other) {
  return dot(place, other) - 0.5 * squared_norm(other);
}

/// Takes off what is nearer to `other` than to the origin. `room` is for its use.
void cut(Corners& cell, const Point2& other, Corners& room) {
  const auto is_beyond = [&](const Point2& corner) { return beyond_bisector(corner, other) > 0.0; };
  if (std::none_of(cell.begin(), cell.end(), is_beyond)) return;
  room.clear();
  for (std::size_t k = 0; k < cell.size(); ++k) {
    const Point2 &a = cell[k], &b = cell[(k + 1) % cell.size()];
    const double at_a = beyond_bisector(a, other), at_b = beyond_bisector(b, other);
    if (at_a <= 0.0) room.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
      room.push_back(a + (at_a / (at_a - at_b)) * (b - a));
  }
  std::swap(cell, room);
}

/// Of 1, |x| and |x|^2.
struct Integrals {
  double area = 0.0, distance = 0.0, squared = 0.0;
};

/// Twice the integral of sec^3 from 0 to the angle of tangent t.
double secant_cubed(double t) {
  return t * std::sqrt(1.0 + t * t) + std::asinh(t);
}

/// Over the triangle of the origin, a and b, in polar coordinates about the height on ab: out to
/// h / cos(angle) the distance integrates to h^3 / 3 times sec^3, its square to h^4 / 4 times
/// sec^4.
void add_triangle(const Point2& a, const Point2& b, Integrals& sums) {
  const Point2 side = b - a;
  const double length = norm(side);
  if (length == 0.0) return;
  const double h = cross(a, b) / length;
  if (h <= 0.0) return;  // the point lies on this side: there is no triangle
  const double from = dot(a, side) / length, to = dot(b, side) / length;
  sums.area += 0.5 * h * length;
  sums.distance += h * h * h / 6.0 * (secant_cubed(to / h) - secant_cubed(from / h));
  sums.squared += 0.25 * h * h * h * (to - from) + h / 12.0 * (to * to * to - from * from * from);
}

/// The cell of point i; empty for a later twin.
Corners cell_of(std::size_t i, std::span<const Point2> points, const Rectangle& window,
                Corners& room) {
  const Point2 own = points[i];
  Corners cell = {window.low - own, Point2{window.high.x, window.low.y} - own, window.high - own,
                  Point2{window.low.x, window.high.y} - own};
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j == i) continue;
    if (points[j] != own)
      cut(cell, points[j] - own, room);
    else if (j < i)
      return {};
  }
  return cell;
}

}  // namespace

EmptySpaceMoments empty_space_by_all_bisectors(std::span<const Point2> points,
                                               const Rectangle& window) {
  PHYTOBENCH_EXPECT(!points.empty());
  Integrals sums;
  Corners room;
  for (std::size_t i = 0; i < points.size(); ++i) {
    PHYTOBENCH_EXPECT(window.contains(points[i]));
    const Corners cell = cell_of(i, points, window, room);
    for (std::size_t k = 0; k < cell.size(); ++k)
      add_triangle(cell[k], cell[(k + 1) % cell.size()], sums);
  }
  constexpr double rounding = 1e-12;  // of a sum over thousands of cells
  PHYTOBENCH_ENSURE(std::abs(sums.area - window.area()) <= rounding * window.area());
  return {sums.distance / sums.area, sums.squared / sums.area};
}

}  // namespace phytobench
