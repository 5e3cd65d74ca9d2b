// SPDX-License-Identifier: MIT
#include "cli/new_folder.hpp"

#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace fs = std::filesystem;

NewFolder::NewFolder(const fs::path& folder) {
  std::error_code ignored;
  fs::path above = folder;
  // As "maps/" names the same folder as "maps".
  if (!above.has_filename()) above = above.parent_path();
  for (; !above.empty() && !fs::exists(above, ignored); above = above.parent_path())
    made_.push_back(above);
  make_folder(folder);
}

NewFolder::~NewFolder() {
  std::error_code error;
  // Only what is empty goes.
  for (const fs::path& folder : made_)
    if (!fs::remove(folder, error)) return;
}

}  // namespace phytobench::cli
