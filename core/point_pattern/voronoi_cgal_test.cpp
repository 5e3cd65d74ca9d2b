// SPDX-License-Identifier: MIT
// Cells of the suite against CGAL's. Left out where CGAL is not there.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/point_pattern/cgal_voronoi_oracle.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/point_pattern/voronoi.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using test_patterns::Points;

/// Integrals over a polygon around the origin, by Simpson's rule along its sides: no closed form.
CellIntegrals along_sides(const Points& corners) {
  CellIntegrals sum;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point2 a = corners[k], b = corners[(k + 1) % corners.size()];
    const double twice_area = cross(a, b);
    constexpr int steps = 400;
    for (int s = 0; s <= steps; ++s) {
      const double weight = (s == 0 || s == steps ? 1.0
                             : s % 2 == 1         ? 4.0
                                                  : 2.0) /
                            (3 * steps) * twice_area;
      const Point2 v = a + (1.0 * s / steps) * (b - a);
      sum.area += weight / 2;
      sum.distance += weight / 3 * norm(v);
      sum.squared_distance += weight / 4 * squared_norm(v);
      sum.moment = sum.moment + (weight / 3) * v;
    }
  }
  return sum;
}

/// Around the points, so that their cells end at the window's border: mirrored in its sides, or all
/// images on a torus.
Points surrounded(const Points& points, const Window& window) {
  Points all = points;
  const Rectangle& box = window.bounding_box();
  for (const Point2& p : points) {
    if (window.kind() == WindowKind::torus) {
      for (int ky = -2; ky <= 2; ++ky)
        for (int kx = -2; kx <= 2; ++kx)
          if (kx != 0 || ky != 0) all.push_back({p.x + kx * box.width(), p.y + ky * box.height()});
      continue;
    }
    all.push_back({2 * box.low.x - p.x, p.y});
    all.push_back({2 * box.high.x - p.x, p.y});
    all.push_back({p.x, 2 * box.low.y - p.y});
    all.push_back({p.x, 2 * box.high.y - p.y});
  }
  return all;
}

void expect_cells_of_cgal(const Points& points, const Window& window) {
  const auto found = voronoi_integrals(points, window);
  const auto cells = cgal_oracle::voronoi_cells(surrounded(points, window), points.size());
  const double width = window.bounding_box().width();
  for (std::size_t i = 0; i < points.size(); ++i) {
    Points corners;
    for (const Point2& corner : cells[i]) corners.push_back(corner - points[i]);
    const CellIntegrals expected = along_sides(corners);
    const double area = std::max(expected.area, 1e-3 * window.area());
    EXPECT_NEAR(found[i].area, expected.area, 1e-6 * area) << i;
    EXPECT_NEAR(found[i].distance, expected.distance, 1e-6 * area * width) << i;
    EXPECT_NEAR(found[i].squared_distance, expected.squared_distance, 1e-6 * area * width * width);
    EXPECT_NEAR(found[i].moment.x, expected.moment.x, 1e-6 * area * width) << i;
    EXPECT_NEAR(found[i].moment.y, expected.moment.y, 1e-6 * area * width) << i;
  }
}

TEST(VoronoiCgalOracle, CellsAreThose) {
  const Rectangle box{{-2, 3}, {5, 8}};
  for (const Window& window : {Window::rectangle(box), Window::torus(box)}) {
    for (const std::size_t count : {1u, 2u, 3u, 7u, 60u})
      expect_cells_of_cgal(test_patterns::random_points(window, count, count), window);
    expect_cells_of_cgal(test_patterns::clustered_points(window, 60, 0.02, 5), window);
  }
}

}  // namespace
}  // namespace phytobench
