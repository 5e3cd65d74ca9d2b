// SPDX-License-Identifier: MIT
#include "cli/source_tree.hpp"

#include "benchmarks/comparison/side.hpp"

namespace phytobench::cli {

std::filesystem::path source_tree() {
  const SideContext context = side_context();
  for (std::filesystem::path folder = context.program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    if (std::filesystem::exists(folder / "benchmarks" / "baselines")) return folder;
  return context.folder;
}

}  // namespace phytobench::cli
