// SPDX-License-Identifier: MIT
#include "cli/terrain_folder.hpp"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "cli/output_files.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* summary_name = "summary.json";

/// Of a summary that may be anybody's: only plain names of files count.
void add_names(const nlohmann::json& summary, const char* key, std::set<std::string>& names) {
  const auto list = summary.find(key);
  if (list == summary.end() || !list->is_array()) return;
  for (const nlohmann::json& name : *list)
    if (name.is_string() && fs::path(name.get<std::string>()).filename() == name.get<std::string>())
      names.insert(name.get<std::string>());
}

/// What the summary of the last run in the folder names.
std::set<std::string> files_of_last_run(const fs::path& folder) {
  const fs::path file = folder / summary_name;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {};
  const auto summary = nlohmann::json::parse(read_text_file(file), nullptr, false);
  if (!summary.is_object() || summary.value("schema", nlohmann::json()) != "phytobench/terrain-1")
    return {};
  std::set<std::string> names;
  for (const char* key : {"files", "older_files"}) add_names(summary, key, names);
  return names;
}

}  // namespace

TerrainFolder::TerrainFolder(const std::string& folder) : folder_(folder) {
  if (folder.empty()) return;
  made_ = NewFolder(folder_);
  lock_ = FolderLock(folder_);
  refuse_unwritable_files({(folder_ / summary_name).string()});
}

void TerrainFolder::add(std::vector<FileContent> files) {
  for (FileContent& file : files) {
    names_.push_back(file.file.string());
    files_.push_back({folder_ / file.file, std::move(file.content)});
  }
}

std::vector<std::string> TerrainFolder::names() const {
  std::vector<std::string> names = names_;
  names.emplace_back(summary_name);
  return names;
}

std::vector<std::string> TerrainFolder::older_files() const {
  std::vector<std::string> older;
  const std::vector<std::string> own = names();
  std::error_code ignored;
  for (const std::string& name : files_of_last_run(folder_))
    if (std::find(own.begin(), own.end(), name) == own.end() && fs::exists(folder_ / name, ignored))
      older.push_back(name);
  return older;
}

void TerrainFolder::write(std::string summary, const std::vector<fs::path>& inputs) {
  files_.push_back({folder_ / summary_name, std::move(summary)});
  for (const FileContent& file : files_)
    for (const fs::path& input : inputs) {
      std::error_code ignored;
      if (!input.empty() && fs::equivalent(file.file, input, ignored))
        throw InputError(file.file.string() +
                         ": would overwrite a file that the site is read from; use another --out");
    }
  write_files_atomically(files_);
}

}  // namespace phytobench::cli
