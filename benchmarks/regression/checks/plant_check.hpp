// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/tree/plant.hpp"

namespace phytobench {

/// What is wrong with the plant that was made of a skeleton whose branches do not hang, in one
/// line; empty if nothing. Radii must follow the power-sum rule ([Brzoska2019] eq. 11), vertices
/// and triangles the closed formulae, rings must lie around their nodes, leaves come as often as
/// their probability says (within five standard deviations), and all numbers be finite.
std::string objection_to_plant(const Plant& plant, const Skeleton& grown,
                               const PlantParameters& parameters);

}  // namespace phytobench
