// SPDX-License-Identifier: MIT
#pragma once

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// Whether no seed becomes a plant in the step that is being done.
bool is_bad_year(const PopulationParameters& parameters, std::int32_t step);

/// Seeds of one step ([Alsweis] sec. 4.4, 4.6): resting ones die, germinate or go on resting, then
/// plants above their threshold shed fresh ones, which die, rest or germinate at once. What
/// germinates in a good year may become a plant. Throws InputError where plants and seeds would be
/// more than parameters.most_plants.
void reproduce(PopulationState& state, const PopulationParameters& parameters);

}  // namespace phytobench
