// SPDX-License-Identifier: MIT
#include "core/terrain/sun/hourly_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// The share of the way from the start up to the greatest elevation, hour `k` of `hours`.
double ascent(int k, int hours, EvenHours even_hours) {
  if (hours < 3) return 0.0;
  if (even_hours == EvenHours::tent)
    return 1.0 - std::abs(2.0 * k / static_cast<double>(hours - 1) - 1.0);
  const int steps = (hours - 1) / 2;
  return static_cast<double>(std::min(k, hours - 1 - k)) / steps;
}

}  // namespace

std::vector<SunAngles> sun_angles(const HourlyPath& path) {
  PHYTOBENCH_EXPECT(path.hours >= 1);
  std::vector<SunAngles> angles;
  for (int k = 0; k < path.hours; ++k) {
    const double climbed = ascent(k, path.hours, path.even_hours);
    const double turned = path.hours == 1 ? 0.0 : 180.0 * k / (path.hours - 1);
    angles.push_back({path.start_elevation + climbed * (path.max_elevation - path.start_elevation),
                      path.start_azimuth + turned});
  }
  return angles;
}

}  // namespace phytobench
