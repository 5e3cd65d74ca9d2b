// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/terrain/files/height_file.hpp"
#include "core/terrain/height_field.hpp"
#include "core/terrain/site_parameters.hpp"

namespace phytobench {

/// The index of the soil of each id; -1 without data. Ids of soils differ. Throws InputError that
/// begins with `name`, the map's, for ids without a soil.
std::vector<std::int16_t> soils_of_ids(const NumberMap& map, std::span<const Soil> soils,
                                       const std::string& name);

}  // namespace phytobench
