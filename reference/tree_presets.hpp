// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace phytobench {

/// A parameter file for `grow` that comes with the suite: of a paper's figure, or of our own.
struct TreePreset {
  std::string name;     ///< "figure-43-middle"; unique
  std::string summary;  ///< the file's first comment
  std::filesystem::path file;
};

/// In the order of their names.
std::vector<TreePreset> tree_presets();

/// The file of that name; a figure without a part ("figure-40") is its left one. Throws InputError
/// with the closest name.
std::filesystem::path tree_preset_file(const std::string& name);

}  // namespace phytobench
