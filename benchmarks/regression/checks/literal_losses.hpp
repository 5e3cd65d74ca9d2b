// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// What is wrong with the losses that `parameters.rule` has found for a stand, in one line; empty
/// if nothing. Every plant is looked at once more among its neighbours alone, by oracles that share
/// no code with core/: for rules of [Alsweis] the literal stand, for shares of ground strips
/// (disc_shares.hpp), for fields an integral over circles around the neighbour's stem. A rule that
/// none of them knows is wrong.
///
/// To 1e-10, which is the rounding of the textbook's areas of zones that nearly touch; fields to
/// 1e-9, as NeighbourField promises. On a torus more than four times as wide as the largest zone;
/// healthy plants, uniform resources, TieRule::share.
std::string objection_to_rule_losses(std::span<const double> found,
                                     const PopulationParameters& parameters, const Stand& stand);

}  // namespace phytobench
