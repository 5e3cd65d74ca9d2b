// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/vector3.hpp"

namespace phytobench {

/// When a node perceives an attraction point: within the influence distance, and within half the
/// perception angle of the node's own direction ([Brzoska2019] fig. 26). Compares cosines, not
/// angles, because the arc cosine of the C library differs between processors in the last bit.
class Perception {
 public:
  /// influence_distance > 0, may be infinite; half_angle_rad in (0, pi], pi sees everything.
  Perception(double influence_distance, double half_angle_rad)
      : squared_reach_(influence_distance * influence_distance),
        cosine_(std::cos(half_angle_rad)),
        all_around_(half_angle_rad >= std::numbers::pi) {}

  /// Squared influence distance; a point exactly there is still perceived.
  double squared_reach() const { return squared_reach_; }

  /// The first squared distance that is too far: start a search for the nearest with this and keep
  /// what is strictly smaller.
  double beyond_reach() const {
    return std::nextafter(squared_reach_, std::numeric_limits<double>::infinity());
  }

  /// The angular half of the test, given the squared distance of point and node. A point at the
  /// node itself is perceived.
  bool within_angle(const Vector3& node, const Vector3& direction, const Vector3& point,
                    double squared_distance) const {
    return all_around_ || dot(direction, point - node) >= cosine_ * std::sqrt(squared_distance);
  }

 private:
  double squared_reach_;
  double cosine_;
  bool all_around_;
};

}  // namespace phytobench
