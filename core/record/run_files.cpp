// SPDX-License-Identifier: MIT
#include "core/record/run_files.hpp"

#include "core/contract/text_file.hpp"
#include "core/record/whole_run.hpp"

namespace phytobench {

namespace fs = std::filesystem;

RunContents read_run(const fs::path& folder) {
  return read_whole_run(folder).contents;
}

std::string read_environment(const fs::path& folder) {
  const fs::path file = folder / environment_name;
  return fs::exists(file) ? read_text_file(file) : "{}";
}

}  // namespace phytobench
