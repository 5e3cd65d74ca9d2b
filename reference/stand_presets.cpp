// SPDX-License-Identifier: MIT
#include "reference/stand_presets.hpp"

namespace phytobench {

std::vector<StandPreset> stand_presets() {
  return preset_files("stands");
}

std::filesystem::path stand_preset_file(const std::string& name) {
  return preset_file_named("stands", {&name, 1});
}

}  // namespace phytobench
