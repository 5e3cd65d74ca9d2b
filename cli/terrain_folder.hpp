// SPDX-License-Identifier: MIT
// The folder that `phytobench terrain` writes into.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/new_folder.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/folder_lock.hpp"

namespace phytobench::cli {

/// Keeps files until all are there.
class TerrainFolder {
 public:
  TerrainFolder() = default;
  /// Makes it; nothing for an empty name. Throws if it cannot be written to, or another run does.
  explicit TerrainFolder(const std::string& folder);

  void add(std::vector<FileContent> files);

  /// All that were added, and the summary.
  std::vector<std::string> names() const;

  /// What earlier runs left there and this one is not going to replace, as their summary has it.
  std::vector<std::string> older_files() const;

  /// Throws InputError, with nothing written, where a file is one of the inputs.
  void write(std::string summary, const std::vector<std::filesystem::path>& inputs);

 private:
  std::filesystem::path folder_;
  FolderLock lock_;
  NewFolder made_;  // below the lock: it goes away before another run may begin there
  std::vector<FileContent> files_;
  std::vector<std::string> names_;
};

}  // namespace phytobench::cli
