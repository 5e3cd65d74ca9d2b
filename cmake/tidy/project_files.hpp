// SPDX-License-Identifier: MIT
// The project's files, for the tests that are called tidy.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace phytobench {

inline const std::filesystem::path root = PHYTOBENCH_SOURCE;

/// The whole file, named from the project's root; empty if there is none.
inline std::string read(const std::filesystem::path& file) {
  std::ifstream stream(root / file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace phytobench
