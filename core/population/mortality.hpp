// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// Mean growth of plant i over the last steps, as many as the window has ([Alsweis] (4.8),
/// corrected), or over its whole life if that is shorter, m per step. NaN before its first step.
double mean_recent_growth(const PopulationState& state, std::size_t i);

/// Mean stem radius of plant i over the window, m.
double mean_recent_radius(const PopulationState& state, std::size_t i);

/// Whether plant i dies at the end of this step: of hunger, of age, or of illness.
bool dies(const PopulationState& state, const PopulationParameters& parameters, std::size_t i);

}  // namespace phytobench
