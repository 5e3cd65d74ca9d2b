// SPDX-License-Identifier: MIT
#include "core/point_pattern/random_patterns.hpp"

#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/point_pattern/point_limit.hpp"
#include "core/random/distributions.hpp"

namespace phytobench {

namespace {

/// [Alsweis] eq. 2.6 and 2.7. `use` takes each point as it comes, so that a window need not store
/// what it drops.
template <typename Use>
void draw_outwards(double intensity, double radius, UnitStream& stream, const Use& use) {
  PHYTOBENCH_EXPECT(std::isfinite(intensity) && intensity > 0.0);
  PHYTOBENCH_EXPECT(std::isfinite(radius) && radius > 0.0);
  const double mean_area = std::numbers::pi * intensity;
  refuse_too_many_points(mean_area * radius * radius, "lower the intensity or the window's size");
  // q_i is the running sum of -ln v_i: intensity * area of the circle through P_i.
  for (double q = random_exponential(stream);; q += random_exponential(stream)) {
    const double distance = std::sqrt(q / mean_area);
    if (distance > radius) return;
    const double angle = 2.0 * std::numbers::pi * stream.next_unit();
    use(Point2{distance * std::cos(angle), distance * std::sin(angle)});
  }
}

}  // namespace

std::vector<Point2> uniform_points(const Window& window, std::size_t count, UnitStream& stream) {
  refuse_too_many_points(static_cast<double>(count), "lower the number of points");
  std::vector<Point2> points;
  points.reserve(count);
  while (points.size() < count) points.push_back(window.random_point(stream));
  return points;
}

std::vector<Point2> poisson_points_outwards(double intensity, double radius, UnitStream& stream) {
  std::vector<Point2> points;
  draw_outwards(intensity, radius, stream, [&](const Point2& p) { points.push_back(p); });
  return points;
}

std::vector<Point2> poisson_points(const Window& window, double intensity, UnitStream& stream) {
  const Rectangle& box = window.bounding_box();
  const Point2 half = 0.5 * (box.high - box.low);
  const Point2 centre = box.low + half;
  std::vector<Point2> points;
  draw_outwards(intensity, norm(half), stream, [&](const Point2& from_centre) {
    const Point2 p = centre + from_centre;
    if (window.contains(p)) points.push_back(p);
  });
  return points;
}

}  // namespace phytobench
