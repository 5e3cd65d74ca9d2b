// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/population/population.hpp"

namespace phytobench {

/// Plants from a CSV file with columns x and y (m, on the ground), radius (of the stem, m, > 0 and
/// at most the largest of its species) and species (its name; may be missing if there is one only),
/// in the order of the file. `parameters` have passed check_parameters(). Throws InputError with
/// file:line.
std::vector<StartPlant> read_plants_file(const std::filesystem::path& file,
                                         const PopulationParameters& parameters);

}  // namespace phytobench
