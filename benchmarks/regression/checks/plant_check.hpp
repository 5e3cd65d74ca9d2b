// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/tree/plant.hpp"

namespace phytobench {

/// What is wrong with the plant that was made of a skeleton whose branches do not hang, in one
/// line; empty if nothing. The skeleton must be the one that was grown, radii must follow the
/// power-sum rule ([Brzoska2019] eq. 12), triangles add up to the leaves as the appendix counts
/// them, all numbers be finite; branches and leaves are what branch_mesh_check.hpp and
/// leaf_check.hpp say.
std::string objection_to_plant(const Plant& plant, const Skeleton& grown,
                               const PlantParameters& parameters);

}  // namespace phytobench
