// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/preset_files.hpp"

namespace phytobench {

/// A parameter file for `compete`, with its maps and plants beside it.
using StandPreset = PresetFile;

/// In the order of their names.
std::vector<StandPreset> stand_presets();

/// The file of that name. Throws InputError with the closest one.
std::filesystem::path stand_preset_file(const std::string& name);

}  // namespace phytobench
