// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/child_placing.hpp"

#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench {

double child_azimuth(const ComponentValues& values, const ChildPlacingKeys& keys,
                     const SiblingNumber& child, double regular_deg) {
  return regular_deg + values.number_for_child(keys.azimuth, child);
}

Frame child_frame(const ComponentValues& values, const ChildPlacingKeys& keys,
                  const SiblingNumber& child, const Vector3& origin, double azimuth_deg,
                  double regular_tilt_deg) {
  const double tilt = regular_tilt_deg + values.number_for_child(keys.tilt, child);
  Frame frame =
      rolled(outward_frame(origin, azimuth_deg, tilt), values.number_for_child(keys.roll, child));
  frame.scale = values.number_for_child(keys.scale, child);
  return frame;
}

}  // namespace phytobench
