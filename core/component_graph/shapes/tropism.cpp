// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/tropism.hpp"

#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench {

Vector3 pull_at(const ComponentInput& input, const Vector3& local, const Tropism& tropism) {
  Vector3 pull;
  const Vector3 place = input.frame.place(local);
  const auto add = [&](const VectorField& field, double weight_deg) {
    if (weight_deg == 0.0) return;
    pull = pull + radians(weight_deg) * direction_of(field, place, input.context.time);
  };
  add(*input.context.photo, tropism.photo_deg);
  add(*input.context.gravi, tropism.gravi_deg);
  return input.frame.local_direction(pull);
}

Frame pulled(const Frame& frame, const Vector3& pull, double share) {
  const double strength = norm(pull);
  const Vector3 across = cross(frame.y, pull);
  const double sine = norm(across);
  constexpr double no_plane = 1e-12;
  if (!(sine > no_plane * strength)) return frame;
  const double angle = std::atan2(sine, dot(frame.y, pull));
  const double left = 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-strength * share));
  return frame.turned(Rotation::about(across / sine, angle - left));
}

}  // namespace phytobench
