// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/terrain/files/raster.hpp"

namespace phytobench {

/// An ESRI ASCII grid from its text: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter,
/// cellsize or dx and dy, perhaps NODATA_value (-9999 without it), in any order and either case,
/// then the rows from the north. Where the first row fills the first line, every row must fill one;
/// otherwise rows may be broken anywhere. `projection` is the text of the .prj file beside it,
/// perhaps empty. `name` stands for the file. Throws InputError with name:line.
Raster parse_ascii_grid(std::string_view text, const std::string& name,
                        const std::string& projection);

}  // namespace phytobench
