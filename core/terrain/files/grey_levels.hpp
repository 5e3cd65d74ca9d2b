// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/terrain/files/raster.hpp"

namespace phytobench {

/// The grey levels of a PNG of 8 or 16 bits, as numbers from 0; every pixel has data. `name` stands
/// for the file. Throws InputError, also for colours, opacity and fewer bits.
Raster parse_grey_levels(std::string_view bytes, const std::string& name);

}  // namespace phytobench
