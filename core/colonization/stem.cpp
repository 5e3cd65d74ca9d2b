// SPDX-License-Identifier: MIT
#include "core/colonization/stem.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench {

namespace {

/// The vertical turned by a random angle about a random horizontal axis. Draws the angle, then
/// three numbers for the axis, of which the vertical one is dropped.
Vector3 tilted_vertical(double tilt_rad, UnitStream& stream) {
  const double angle = stream.next_between(-tilt_rad, tilt_rad);
  const double axis_x = stream.next_between(-1.0, 1.0);
  stream.next_unit();
  const double axis_z = stream.next_between(-1.0, 1.0);
  const double length = norm({axis_x, 0.0, axis_z});
  if (length == 0.0) return {0.0, 1.0, 0.0};
  const Vector3 axis = Vector3{axis_x, 0.0, axis_z} / length;
  const Vector3 up{0.0, 1.0, 0.0};
  return std::cos(angle) * up + std::sin(angle) * cross(axis, up);
}

}  // namespace

std::int32_t append_stem(Skeleton& skeleton, std::int32_t foot, double length, double piece_length,
                         double tilt_rad, UnitStream& stream) {
  // A remainder this small comes from rounding, not from a wish for another piece.
  const double negligible = 1e-9 * piece_length;
  std::int32_t top = foot;
  for (double left = length; left > negligible; left -= piece_length) {
    const double piece = std::min(left, piece_length);
    const Vector3 direction = tilted_vertical(tilt_rad, stream);
    top = skeleton.append(top, skeleton.position(top) + piece * direction);
  }
  return top;
}

}  // namespace phytobench
