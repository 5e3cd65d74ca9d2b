// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/preset_files.hpp"

namespace phytobench {

/// An L-system for `derive`, in the format of core/lsystem/read_lsystem.hpp.
using LSystemPreset = PresetFile;

/// In the order of their names.
std::vector<LSystemPreset> lsystem_presets();

/// The file of that name. Throws InputError with the closest one.
std::filesystem::path lsystem_preset_file(const std::string& name);

}  // namespace phytobench
