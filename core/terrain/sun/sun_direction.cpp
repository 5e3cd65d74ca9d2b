// SPDX-License-Identifier: MIT
#include "core/terrain/sun/sun_direction.hpp"

#include <cmath>
#include <numbers>

namespace phytobench {

namespace {

struct SineCosine {
  double sine;
  double cosine;
};

/// Quarter turns are exact: the sun in the zenith, or due east, is just there.
SineCosine sine_cosine(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  if (turned == 0.0) return {0.0, 1.0};
  if (turned == 90.0) return {1.0, 0.0};
  if (turned == -90.0) return {-1.0, 0.0};
  if (std::abs(turned) == 180.0) return {0.0, -1.0};
  const double radians = turned * (std::numbers::pi / 180.0);
  return {std::sin(radians), std::cos(radians)};
}

}  // namespace

SunDirection direction_of(const SunAngles& angles) {
  const SineCosine elevation = sine_cosine(angles.elevation), azimuth = sine_cosine(angles.azimuth);
  return {elevation.cosine * azimuth.cosine, elevation.cosine * azimuth.sine, elevation.sine};
}

SunDirection rounded(const SunDirection& direction, int decimals) {
  const double scale = std::pow(10.0, decimals);
  // Adding 0 makes -0 a 0.
  const auto round = [scale](double x) { return std::nearbyint(x * scale) / scale + 0.0; };
  return {round(direction.east), round(direction.south), round(direction.up)};
}

}  // namespace phytobench
