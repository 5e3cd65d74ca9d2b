// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/terrain/files/raster.hpp"

namespace phytobench {

/// Rows of numbers with commas between them, the most northern first, all of the same length; "nan"
/// or nothing where there is no data. Empty lines and those that start with # are skipped. `name`
/// stands for the file. Throws InputError with name:line.
Raster parse_number_rows(std::string_view text, const std::string& name);

}  // namespace phytobench
