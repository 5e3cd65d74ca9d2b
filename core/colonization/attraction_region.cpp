// SPDX-License-Identifier: MIT
#include "core/colonization/attraction_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// From the shares of the angle and of the measure between the radii.
Vector3 point_in_plane(double angle_share, double radius) {
  const double angle = 2.0 * std::numbers::pi * angle_share;
  return {radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

/// Uniform in area (power 2) or volume (power 3) between two radii, which rounding must not leave.
double radius_between(double inner, double outer, double share, double power) {
  const double a = std::pow(inner, power), b = std::pow(outer, power);
  return std::clamp(std::pow(a + share * (b - a), 1.0 / power), inner, outer);
}

Vector3 point_in_shell(const RoundRegion& region, UnitStream& stream) {
  const double height = stream.next_between(-1.0, 1.0);
  const double angle_share = stream.next_unit();
  const double radius = radius_between(region.inner_radius, region.radius, stream.next_unit(), 3.0);
  const Vector3 flat = point_in_plane(angle_share, std::sqrt((1.0 - height) * (1.0 + height)));
  return radius * Vector3{flat.x, flat.y, height};
}

Vector3 point_in(const RoundRegion& region, UnitStream& stream) {
  if (region.shape == RoundShape::sphere_shell) return point_in_shell(region, stream);
  const double angle_share = stream.next_unit();
  if (region.shape == RoundShape::ring) return point_in_plane(angle_share, region.radius);
  const double inner = region.shape == RoundShape::disc ? 0.0 : region.inner_radius;
  return point_in_plane(angle_share, radius_between(inner, region.radius, stream.next_unit(), 2.0));
}

}  // namespace

std::vector<Vector3> attraction_points(const RoundRegion& region, std::size_t count,
                                       UnitStream& stream) {
  PHYTOBENCH_EXPECT(region.radius > 0.0 && std::isfinite(region.radius));
  PHYTOBENCH_EXPECT(region.inner_radius >= 0.0 && region.inner_radius <= region.radius);
  std::vector<Vector3> points;
  points.reserve(count);
  while (points.size() < count) points.push_back(region.centre + point_in(region, stream));
  return points;
}

}  // namespace phytobench
