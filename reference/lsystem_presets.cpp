// SPDX-License-Identifier: MIT
#include "reference/lsystem_presets.hpp"

namespace phytobench {

namespace {

constexpr const char* lsystem_folder = "lsystems";
constexpr const char* lsystem_extension = ".lsys";

}  // namespace

std::vector<LSystemPreset> lsystem_presets() {
  return preset_files(lsystem_folder, lsystem_extension);
}

std::filesystem::path lsystem_preset_file(const std::string& name) {
  return preset_file_named(lsystem_folder, {&name, 1}, lsystem_extension);
}

}  // namespace phytobench
