// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/preset_files.hpp"

namespace phytobench {

/// A graph of components for `build`.
using GraphPreset = PresetFile;

/// In the order of their names.
std::vector<GraphPreset> graph_presets();

/// The file of that name. Throws InputError with the closest one.
std::filesystem::path graph_preset_file(const std::string& name);

}  // namespace phytobench
