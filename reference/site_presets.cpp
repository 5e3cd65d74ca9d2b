// SPDX-License-Identifier: MIT
#include "reference/site_presets.hpp"

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

constexpr const char* entry_folder = "sites/entries";

}  // namespace

std::vector<SitePreset> site_presets() {
  return preset_files("sites");
}

std::filesystem::path site_preset_file(const std::string& name) {
  return preset_file_named("sites", {&name, 1});
}

std::vector<PresetFile> site_entry_files() {
  return preset_files(entry_folder);
}

std::filesystem::path site_entry_file(const std::string& name) {
  std::vector<std::string> known;
  for (const PresetFile& file : site_entry_files()) {
    if (file.name == name) return file.file;
    known.push_back(file.name);
  }
  throw InputError("unknown entries '" + name + "'" + did_you_mean(name, known) +
                   "; see phytobench list site-entries, or give a file name that ends in .toml");
}

}  // namespace phytobench
