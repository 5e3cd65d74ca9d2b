// SPDX-License-Identifier: MIT
#include "core/colonization/growth_direction.hpp"

#include <cmath>
#include <numbers>

#include "core/geometry/rotation.hpp"

namespace phytobench {

namespace {

std::optional<Vector3> normalised(const Vector3& v) {
  const double length = norm(v);
  if (!(length > 0.0)) return std::nullopt;
  return v / length;
}

}  // namespace

std::optional<Vector3> growth_direction(const Vector3& sum, const Vector3& tropism,
                                        TropismOrder order) {
  if (order == TropismOrder::before_normalising) return normalised(sum + tropism);
  const std::optional<Vector3> attracted = normalised(sum);
  if (!attracted) return std::nullopt;
  return normalised(*attracted + tropism);
}

DirectionLimit::DirectionLimit(double half_angle_rad)
    : cosine_(std::cos(half_angle_rad)),
      sine_(std::sin(half_angle_rad)),
      unlimited_(half_angle_rad >= std::numbers::pi) {}

Vector3 DirectionLimit::operator()(const Vector3& direction, const Vector3& node_direction) const {
  const double along = dot(direction, node_direction);
  if (unlimited_ || along >= cosine_) return direction;
  const Vector3 across = direction - along * node_direction;
  // Straight backwards there is no plane: what is left of `across` is rounding noise.
  constexpr double noise = 1e-8;
  const double across_length = norm(across);
  const Vector3 sideways =
      across_length > noise ? across / across_length : any_perpendicular(node_direction);
  return cosine_ * node_direction + sine_ * sideways;
}

}  // namespace phytobench
