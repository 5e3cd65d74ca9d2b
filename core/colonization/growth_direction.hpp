// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/colonization/growth_parameters.hpp"

namespace phytobench {

/// What one attraction point adds to its node's sum. A point exactly at the node adds nothing: eq.
/// 9 would divide by zero. Here, not in the source file, because growth calls it for every point.
inline Vector3 attraction(const Vector3& node, const Vector3& point, AttractionSum kind) {
  const Vector3 offset = point - node;
  if (kind == AttractionSum::raw_vectors) return offset;
  const double length = norm(offset);
  return length > 0.0 ? offset / length : Vector3{};
}

/// Direction (unit length) from a node's attraction sum and the weighted tropism ([Brzoska2019] eq.
/// 9 and 10). Empty where a sum that is to be normalised is zero, which the thesis leaves open: no
/// growth then.
std::optional<Vector3> growth_direction(const Vector3& sum, const Vector3& tropism,
                                        TropismOrder order);

/// Keeps growth within half the perception angle of the node's own direction. Without tropism
/// nothing leaves that cone; with it the direction is turned back to its edge, in the plane of both
/// directions.
class DirectionLimit {
 public:
  /// half_angle_rad in (0, pi]; pi limits nothing.
  explicit DirectionLimit(double half_angle_rad);
  Vector3 operator()(const Vector3& direction, const Vector3& node_direction) const;

 private:
  double cosine_;
  double sine_;
  bool unlimited_;
};

}  // namespace phytobench
