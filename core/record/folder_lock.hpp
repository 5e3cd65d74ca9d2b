// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <utility>

namespace phytobench {

/// Two runs in one folder would write over each other: a run holds this while it writes. The system
/// lets go of it with the program, however that ends; nothing stays in the folder.
class FolderLock {
 public:
  FolderLock() = default;  ///< holds nothing

  /// Throws InputError if another holds it. Holds nothing where there is no such folder, or where
  /// the file system knows no locks.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  int descriptor_ = -1;  ///< of the folder
};

}  // namespace phytobench
