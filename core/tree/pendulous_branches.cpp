// SPDX-License-Identifier: MIT
#include "core/tree/pendulous_branches.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/rotation.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

constexpr Vector3 downwards{0.0, -1.0, 0.0};

/// The turn of one edge that points along `direction`. Straight up or down it has no axis and no
/// angle either.
Rotation towards_ground(const Vector3& direction, double intensity) {
  const Vector3 axis = cross(direction, downwards);
  const double across = norm(axis);
  if (across == 0.0) return {};
  const double theta = std::atan2(across, dot(direction, downwards));
  return Rotation::about(axis / across, pendulous_angle(theta, intensity));
}

}  // namespace

double pendulous_angle(double theta_rad, double intensity) {
  return intensity * (1.0 - theta_rad / std::numbers::pi) * theta_rad;
}

Skeleton bend_branches(const Skeleton& skeleton, const PendulousBranches& pendulous) {
  if (pendulous.intensity == 0.0) return skeleton;
  const std::vector<std::int32_t> depths = node_depths(skeleton);
  std::vector<Rotation> carried(skeleton.node_count());  // by all turns from the root to the node
  std::vector<bool> is_moved(skeleton.node_count(), false);
  Skeleton bent(skeleton.positions()[0]);
  bent.reserve(skeleton.node_count());
  for (std::size_t i = 1; i < skeleton.node_count(); ++i) {
    const std::int32_t parent = skeleton.parents()[i];
    const auto p = static_cast<std::size_t>(parent);
    if (depths[i] < pendulous.first_order && !is_moved[p]) {
      bent.append(parent, skeleton.positions()[i]);
      continue;
    }
    is_moved[i] = true;
    const Vector3 edge = carried[p](skeleton.positions()[i] - skeleton.positions()[p]);
    const double length = norm(edge);
    Rotation turn;
    if (length > 0.0) turn = towards_ground(edge / length, pendulous.intensity);
    carried[i] = turn * carried[p];
    bent.append(parent, bent.position(parent) + turn(edge));
  }
  return bent;
}

}  // namespace phytobench
