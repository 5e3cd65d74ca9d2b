// SPDX-License-Identifier: MIT
#include "reference/preset_files.hpp"

#include <algorithm>
#include <sstream>

#include "core/contract/check.hpp"
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

void append_presets(const fs::path& folder, const std::string& extension,
                    std::vector<PresetFile>& presets) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension)
      presets.push_back({entry.path().stem().string(), first_comment(entry.path()), entry.path()});
}

}  // namespace

std::vector<PresetFile> preset_files(const std::string& kind, const std::string& extension) {
  std::vector<PresetFile> presets;
  append_presets(data_folder() / kind, extension, presets);
  for (const std::string& key : paper_keys())
    append_presets(paper_folder(key) / kind, extension, presets);
  std::sort(presets.begin(), presets.end(),
            [](const PresetFile& a, const PresetFile& b) { return a.name < b.name; });
  return presets;
}

fs::path preset_file_named(const std::string& kind, std::span<const std::string> names,
                           const std::string& extension) {
  PHYTOBENCH_EXPECT(!names.empty());
  const std::vector<PresetFile> presets = preset_files(kind, extension);
  std::vector<std::string> known;
  for (const PresetFile& preset : presets) known.push_back(preset.name);
  for (const std::string& wanted : names) {
    const auto found = std::find(known.begin(), known.end(), wanted);
    if (found != known.end()) return presets[static_cast<std::size_t>(found - known.begin())].file;
  }
  const std::string list = kind == "trees" ? "presets" : kind;
  throw InputError("unknown preset '" + names[0] + "'" + did_you_mean(names[0], known) +
                   "; see phytobench list " + list);
}

}  // namespace phytobench
