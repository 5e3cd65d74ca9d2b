// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/terrain/files/gdal/raster_module.hpp"
#include "core/terrain/files/raster.hpp"

namespace phytobench {

/// The file of the module: in $PHYTOBENCH_MODULES, if that is set, or else in the first folder
/// `modules`, as a build has it, or `lib/phytobench`, as an installation has it, that lies beside
/// the program or a folder above it. Nothing where there is none.
std::optional<std::filesystem::path> raster_module_path();

/// "GDAL 3.6.2" or why there is none: "not built: GDAL is missing". Opens the module.
std::string map_reader_name();

/// The module, opened now or before; it stays. Throws InputError saying what to do about `purpose`
/// ("reading x.tif") where it is missing, cannot be loaded, or belongs to another version.
const RasterModule& raster_module(const std::string& purpose);

/// Reads whatever GDAL can. Throws InputError, also for more than one band, a turned map, and no
/// module.
Raster read_gdal_raster(const std::filesystem::path& file);

}  // namespace phytobench
