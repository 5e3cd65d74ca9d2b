// SPDX-License-Identifier: MIT
#include "reference/tree_presets.hpp"

namespace phytobench {

std::vector<TreePreset> tree_presets() {
  return preset_files("trees");
}

std::filesystem::path tree_preset_file(const std::string& name) {
  const std::string names[] = {name, name + "-left"};
  return preset_file_named("trees", names);
}

}  // namespace phytobench
