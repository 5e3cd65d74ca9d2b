// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/found_program.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace phytobench {

namespace fs = std::filesystem;

namespace {

bool can_run(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

}  // namespace

std::optional<fs::path> found_program(const std::string& program) {
  if (program.empty()) return std::nullopt;
  if (program.find('/') != std::string::npos)
    return can_run(program) ? std::optional(fs::absolute(program)) : std::nullopt;
  const char* given = std::getenv("PATH");
  std::string_view folders = given == nullptr ? "/usr/local/bin:/usr/bin:/bin" : given;
  while (!folders.empty()) {
    const std::string_view folder = folders.substr(0, folders.find(':'));
    folders.remove_prefix(std::min(folders.size(), folder.size() + 1));
    const fs::path file = fs::absolute(folder.empty() ? "." : folder) / program;
    if (can_run(file)) return file;
  }
  return std::nullopt;
}

}  // namespace phytobench
