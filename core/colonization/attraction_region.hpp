// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/vector3.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// Round regions that attraction points can be spread over. [Liebemann2017] fig. 3.2 says "in a
/// ring with the radius 500" and means one of the flat ones: it gives no inner radius.
enum class RoundShape {
  disc,          ///< in the plane z = centre.z, radius
  annulus,       ///< a disc without the one of inner_radius
  ring,          ///< the circle line of radius
  sphere_shell,  ///< between two spheres; if the radii are equal, the surface of one
};

struct RoundRegion {
  RoundShape shape = RoundShape::disc;
  double radius = 0.0;        ///< length units, > 0
  double inner_radius = 0.0;  ///< of annulus and shell, [0, radius]
  Vector3 centre;
};

/// `count` uniform points in the region. Each takes two numbers from the stream (angle, then
/// radius; a ring takes the angle only), in the shell three: height, angle, radius.
std::vector<Vector3> attraction_points(const RoundRegion& region, std::size_t count,
                                       UnitStream& stream);

}  // namespace phytobench
