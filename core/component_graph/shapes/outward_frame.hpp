// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "core/component_graph/frame.hpp"

namespace phytobench {

/// 180 (3 - sqrt(5)) degrees: the smaller part of a full turn cut by the golden section.
inline constexpr double golden_angle_deg = 137.50776405003785;

inline double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

/// Unit vector at right angles to y. Azimuth 0 is z; it grows counter-clockwise seen from +y.
inline Vector3 outward(double azimuth_deg) {
  const double azimuth = radians(azimuth_deg);
  return {std::sin(azimuth), 0.0, std::cos(azimuth)};
}

/// The directions of a child that leaves the y axis at the angle `tilt_deg` towards an azimuth. Its
/// x stays at right angles to y, its z looks away from the axis: what bends about x by a positive
/// angle bends outwards, and a leaf in its plane of x and y turns its upper side (-z) to the axis.
inline Frame outward_frame(const Vector3& origin, double azimuth_deg, double tilt_deg) {
  const Vector3 out = outward(azimuth_deg);
  const double tilt = radians(tilt_deg);
  const double along = std::cos(tilt), across = std::sin(tilt);
  Frame frame;
  frame.origin = origin;
  frame.x = {out.z, 0.0, -out.x};
  frame.y = {across * out.x, along, across * out.z};
  frame.z = {along * out.x, -across, along * out.z};
  return frame;
}

/// Turned about its own y.
inline Frame rolled(const Frame& frame, double roll_deg) {
  return roll_deg == 0.0 ? frame : frame.turned(Rotation::about(frame.y, radians(roll_deg)));
}

}  // namespace phytobench
