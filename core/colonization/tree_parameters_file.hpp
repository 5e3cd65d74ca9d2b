// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/colonization/tree_parameters.hpp"

namespace phytobench {

/// Reads a tree from a TOML file. Missing keys take their defaults. Throws InputError with file,
/// line, key and what is allowed.
TreeParameters read_tree_parameters(const std::filesystem::path& file);

/// A table of a TOML file ("sensitivity[3].tree"), or the whole file.
struct TreeSource {
  std::filesystem::path file;
  std::string table;  ///< empty: the whole file
};

/// Reads it from several sources, a later one replacing keys of an earlier one.
TreeParameters read_tree_parameters(const std::vector<TreeSource>& sources);

/// The same from text; `name` stands for the file in messages.
TreeParameters parse_tree_parameters(std::string_view text, std::string_view name);

/// A file with every key at its default, each with meaning, unit, range and source.
std::string example_tree_file();

}  // namespace phytobench
