// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace phytobench::cli {

/// A folder for files that are to come, made with those above it. Where it was made here, and
/// nothing came, it goes away again with this.
class NewFolder {
 public:
  NewFolder() = default;  ///< none
  /// Throws EnvironmentError if it cannot be made.
  explicit NewFolder(const std::filesystem::path& folder);
  ~NewFolder();
  NewFolder(NewFolder&& other) noexcept { *this = std::move(other); }
  NewFolder& operator=(NewFolder&& other) noexcept {
    made_.swap(other.made_);
    return *this;
  }

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

}  // namespace phytobench::cli
