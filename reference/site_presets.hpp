// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/terrain/site_file.hpp"
#include "reference/preset_files.hpp"

namespace phytobench {

/// A site for `terrain`, with its heights beside it.
using SitePreset = PresetFile;

/// In the order of their names.
std::vector<SitePreset> site_presets();

/// The file of that name. Throws InputError with the closest one.
std::filesystem::path site_preset_file(const std::string& name);

/// Files of biomes, soils and species that sites name as their `entries`, and the same search.
std::vector<PresetFile> site_entry_files();
std::filesystem::path site_entry_file(const std::string& name);

}  // namespace phytobench
