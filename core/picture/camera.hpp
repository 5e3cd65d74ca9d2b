// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/bounding_box.hpp"
#include "core/geometry/vector3.hpp"

namespace phytobench {

/// A camera on a sphere about the point it looks at ([Brzoska2019] fig. 25 and sec. 5.4). With
/// theta = azimuth and phi = 90 degrees - elevation its place is target + distance (sin phi cos
/// theta, cos phi, sin phi sin theta); the formula is only in the thesis' picture, y up is our
/// reading (ambiguity A14).
struct Camera {
  Vector3 target;
  double azimuth_deg = 90.0;     ///< 0 looks from +x, 90 from +z
  double elevation_deg = 10.0;   ///< [-90, 90]; 90 looks straight down
  double distance = 10.0;        ///< of the camera from the target, length units, > 0
  double view_angle_deg = 30.0;  ///< between the upper and the lower edge of the picture, (0, 180)

  Vector3 position() const;

  /// Moves camera and target together ([Brzoska2019] sec. 4.2).
  Camera shifted(const Vector3& by) const;
};

/// Unit vectors: where a camera looks, what it sees as right and as up.
struct ViewFrame {
  Vector3 forward, right, up;
};
ViewFrame view_frame(const Camera& camera);

/// The same camera with target and distance such that a box fills the picture from any side.
/// `aspect` is width over height, > 0.
Camera fitted(Camera camera, const BoundingBox& box, double aspect);

}  // namespace phytobench
