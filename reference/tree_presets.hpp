// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/preset_files.hpp"

namespace phytobench {

/// A parameter file for `grow`.
using TreePreset = PresetFile;

/// In the order of their names.
std::vector<TreePreset> tree_presets();

/// The file of that name; a figure without a part ("figure-40") is its left one. Throws InputError
/// with the closest name.
std::filesystem::path tree_preset_file(const std::string& name);

}  // namespace phytobench
