// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// How branches hang ([Brzoska2019] sec. 3.4.5).
struct PendulousBranches {
  double intensity = 0.0;        ///< lambda of eq. 13, [0, 1]; 0 bends nothing
  std::int32_t first_order = 0;  ///< edges that end at this node depth or deeper are bent, >= 0
};

/// psi of [Brzoska2019] eq. 13 in radians: by how much a branch at angle theta to the downward
/// vertical is turned towards it. Zero at 0 and pi, largest at a right angle.
double pendulous_angle(double theta_rad, double intensity);

/// The skeleton with its branches bent towards the ground: from the root outwards, each edge from
/// the first order on is turned about its lower node together with all that it carries. Edges below
/// that order stay as they are, bit for bit. Bending a second time bends further, so keep the
/// original.
Skeleton bend_branches(const Skeleton& skeleton, const PendulousBranches& pendulous);

}  // namespace phytobench
