// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/terrain/files/height_file.hpp"
#include "core/terrain/height_field.hpp"

namespace phytobench {

/// A map of soils from heights alone, as [Lesser2019] sec. 10.4 makes one by posterising: equal
/// intervals of height from the lowest vertex to the highest, one for each id, the first at the
/// bottom. A height on a border belongs to the upper interval, the highest to the last; all of a
/// flat map to the first. -1 where there is no data. At least one id.
NumberMap posterised(const HeightField& field, std::span<const std::int16_t> ids);

}  // namespace phytobench
