// SPDX-License-Identifier: MIT
#include "reference/lsystem_presets.hpp"

namespace phytobench {

namespace {

constexpr const char* folder = "lsystems";
constexpr const char* extension = ".lsys";

}  // namespace

std::vector<LSystemPreset> lsystem_presets() {
  return preset_files(folder, extension);
}

std::filesystem::path lsystem_preset_file(const std::string& name) {
  return preset_file_named(folder, {&name, 1}, extension);
}

}  // namespace phytobench
