// SPDX-License-Identifier: MIT
#include "core/point_pattern/lloyd.hpp"

#include "core/contract/check.hpp"
#include "core/point_pattern/voronoi.hpp"

namespace phytobench {

LloydStep lloyd_step(std::span<const Point2> points, const Window& window, int threads) {
  PHYTOBENCH_EXPECT(!points.empty());
  LloydStep step{{points.begin(), points.end()}};
  const std::vector<CellIntegrals> cells = voronoi_integrals(points, window, threads);
  for (std::size_t i = 0; i < points.size(); ++i) {
    step.energy += cells[i].squared_distance;
    if (!(cells[i].area > 0.0)) continue;
    const Point2 centroid = window.wrapped(points[i] + (1.0 / cells[i].area) * cells[i].moment);
    if (window.contains(centroid)) step.points[i] = centroid;
  }
  step.energy /= window.area() * window.area();
  return step;
}

std::vector<Point2> lloyd_points(std::vector<Point2> points, const Window& window, int steps,
                                 int threads) {
  for (int step = 0; step < steps; ++step) points = lloyd_step(points, window, threads).points;
  return points;
}

}  // namespace phytobench
