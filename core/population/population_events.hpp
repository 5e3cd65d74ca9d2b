// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// Positions in the stand of the plants that event `number` of the parameters selects now,
/// ascending.
std::vector<std::size_t> plants_selected(const PopulationState& state,
                                         const PopulationParameters& parameters,
                                         std::size_t number);

/// Carries out all events of the step that is about to be done: plants fall ill, or are taken out.
/// False if there are none.
bool apply_events(PopulationState& state, const PopulationParameters& parameters);

}  // namespace phytobench
