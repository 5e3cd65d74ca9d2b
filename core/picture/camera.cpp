// SPDX-License-Identifier: MIT
#include "core/picture/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phytobench {

namespace {

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}

/// From the target to the camera.
Vector3 outward(const Camera& camera) {
  const double theta = radians(camera.azimuth_deg), phi = radians(90.0 - camera.elevation_deg);
  return {std::sin(phi) * std::cos(theta), std::cos(phi), std::sin(phi) * std::sin(theta)};
}

}  // namespace

Vector3 Camera::position() const {
  return target + distance * outward(*this);
}

Camera Camera::shifted(const Vector3& by) const {
  Camera moved = *this;
  moved.target = target + by;
  return moved;
}

ViewFrame view_frame(const Camera& camera) {
  const double theta = radians(camera.azimuth_deg);
  const Vector3 forward = -1.0 * outward(camera);
  // Defined by the azimuth alone, so that looking straight down is nothing special.
  const Vector3 right{std::sin(theta), 0.0, -std::cos(theta)};
  return {forward, right, cross(right, forward)};
}

Camera fitted(Camera camera, const BoundingBox& box, double aspect) {
  camera.target = 0.5 * (box.low() + box.high());
  const ViewFrame frame = view_frame(camera);
  const double half_height = std::tan(radians(0.5 * camera.view_angle_deg));
  const double half_width = aspect * half_height;
  constexpr double border = 1.08;
  double needed = 0.0;
  for (const double x : {box.low().x, box.high().x})
    for (const double y : {box.low().y, box.high().y})
      for (const double z : {box.low().z, box.high().z}) {
        const Vector3 corner = Vector3{x, y, z} - camera.target;
        const double ahead = dot(corner, frame.forward);
        needed = std::max({needed, border * std::abs(dot(corner, frame.right)) / half_width - ahead,
                           border * std::abs(dot(corner, frame.up)) / half_height - ahead});
      }
  camera.distance = std::max(needed, 1e-6);
  return camera;
}

}  // namespace phytobench
