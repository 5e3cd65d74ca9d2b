// SPDX-License-Identifier: MIT
#include "reference/tree_presets.hpp"

#include <algorithm>
#include <sstream>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reference/papers.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

/// The comment that a file begins with, up to the line that all of them share.
std::string first_comment(const fs::path& file) {
  std::istringstream lines(read_text_file(file));
  std::string text;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");) {
    if (line.starts_with("# Every key")) break;
    text += (text.empty() ? "" : " ") + line.substr(2);
  }
  return text;
}

void append_presets(const fs::path& folder, std::vector<TreePreset>& presets) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml")
      presets.push_back({entry.path().stem().string(), first_comment(entry.path()), entry.path()});
}

}  // namespace

std::vector<TreePreset> tree_presets() {
  std::vector<TreePreset> presets;
  append_presets(data_folder() / "trees", presets);
  for (const std::string& key : paper_keys()) append_presets(paper_folder(key) / "trees", presets);
  std::sort(presets.begin(), presets.end(),
            [](const TreePreset& a, const TreePreset& b) { return a.name < b.name; });
  return presets;
}

fs::path tree_preset_file(const std::string& name) {
  const std::vector<TreePreset> presets = tree_presets();
  for (const std::string& wanted : {name, name + "-left"})
    for (const TreePreset& preset : presets)
      if (preset.name == wanted) return preset.file;
  std::vector<std::string> names;
  for (const TreePreset& preset : presets) names.push_back(preset.name);
  throw InputError("unknown preset '" + name + "'" + did_you_mean(name, names) +
                   "; see phytobench list presets");
}

}  // namespace phytobench
