// SPDX-License-Identifier: MIT
#include "core/point_pattern/hopkins.hpp"

#include <limits>
#include <vector>

#include "core/contract/check.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/voronoi.hpp"

namespace phytobench {

namespace {

EmptySpaceMoments moments_of(const std::vector<double>& distances) {
  EmptySpaceMoments sum;
  for (const double d : distances) {
    sum.mean_distance += d;
    sum.mean_squared_distance += d * d;
  }
  const auto n = static_cast<double>(distances.size());
  return {sum.mean_distance / n, sum.mean_squared_distance / n};
}

HopkinsIndex ratio(const EmptySpaceMoments& from_places, std::span<const Point2> points,
                   const Window& window, int threads) {
  const EmptySpaceMoments among = moments_of(nearest_distances(points, window, threads));
  return {from_places.mean_distance / among.mean_distance,
          from_places.mean_squared_distance / among.mean_squared_distance};
}

HopkinsIndex undefined() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan};
}

}  // namespace

HopkinsIndex hopkins_exact(std::span<const Point2> points, const Window& window, int threads) {
  if (points.size() < 2) return undefined();
  return ratio(empty_space_moments(points, window, threads), points, window, threads);
}

HopkinsIndex hopkins_sampled(std::span<const Point2> points, const Window& window,
                             std::size_t places, UnitStream& stream, int threads) {
  PHYTOBENCH_EXPECT(places > 0);
  if (points.size() < 2) return undefined();
  const std::vector<Point2> queries = uniform_points(window, places, stream);
  return ratio(moments_of(nearest_distances_from(queries, points, window, threads)), points, window,
               threads);
}

}  // namespace phytobench
