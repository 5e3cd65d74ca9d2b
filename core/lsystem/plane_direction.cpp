// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/lsystem/drawing.hpp"

namespace phytobench {

namespace {

/// Of an angle in [-45, 45] degrees. 30 and 45 degrees, of which the drawings are full, get the
/// nearest doubles, which the sine of a rounded number of radians misses.
PlaneDirection direction_in_first_octants(double degrees) {
  const double size = std::abs(degrees);
  const double radians = degrees * (std::numbers::pi / 180.0);
  if (size == 45.0) return {std::sqrt(0.5), std::copysign(std::sqrt(0.5), degrees)};
  if (size == 30.0) return {std::sqrt(0.75), std::copysign(0.5, degrees)};
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace

PlaneDirection plane_direction(double degrees) {
  PHYTOBENCH_EXPECT(std::isfinite(degrees));
  // Both remainders, and so the number of right angles, are exact.
  const double turned = std::remainder(degrees, 360.0);
  const double rest = std::remainder(turned, 90.0);
  const auto [x, y] = direction_in_first_octants(rest);
  switch (static_cast<int>((turned - rest) / 90.0) & 3) {
    case 1:
      return {0.0 - y, x};
    case 2:
      return {0.0 - x, 0.0 - y};
    case 3:
      return {y, 0.0 - x};
    default:
      return {x, y};
  }
}

}  // namespace phytobench
