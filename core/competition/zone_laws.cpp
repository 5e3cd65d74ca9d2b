// SPDX-License-Identifier: MIT
#include "core/competition/zone_laws.hpp"

#include "core/contract/check.hpp"
#include "core/overlap/lens.hpp"

namespace phytobench {

namespace {

/// Periods that bring the difference nearest to 0.
int nearest_image(double difference, double period) {
  return -static_cast<int>(std::lround(difference / period));
}

}  // namespace

double distance_of_pair(const Discs& zone, const Ground& ground, std::size_t i, std::size_t j,
                        double overlap) {
  if (!ground.torus) return center_distance(zone, ground, i, j, {});
  const TorusImage nearest{nearest_image(zone.x[j] - zone.x[i], ground.period_x()),
                           nearest_image(zone.y[j] - zone.y[i], ground.period_y())};
  const double shortest = center_distance(zone, ground, i, j, nearest);
  const double r = zone.radius[i], s = zone.radius[j];
  // The next image is at least this far: the usual case needs no look at the overlap.
  const double other = std::min(ground.period_x(), ground.period_y()) - shortest;
  if (other > r + s) return shortest;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y) {
      const double d = center_distance(zone, ground, i, j, {nearest.x + x, nearest.y + y});
      if (lens_area(r, s, d) == overlap) return d;
    }
  throw ContractViolation("the overlap of a pair belongs to none of its images");
}

}  // namespace phytobench
