// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/population/population_parameters.hpp"

namespace phytobench {

/// A file that a TOML file names.
struct NamedFile {
  std::string name;  ///< as it is written there
  std::filesystem::path file;

  friend bool operator==(const NamedFile&, const NamedFile&) = default;
};

/// What a TOML file says: all of a run but the plants that a table of its own lists.
struct PopulationFile {
  PopulationParameters parameters;
  std::filesystem::path plants;  ///< for read_plants_file(); empty: none
  /// Plants and maps, without which the TOML file cannot be read again; each name once.
  std::vector<NamedFile> files = {};
};

/// Reads a stand and the maps that it names. Missing keys take their defaults. Throws InputError
/// with file, line, key and what is allowed.
PopulationFile read_population_file(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages, and names of files start at its
/// folder.
PopulationFile parse_population(std::string_view text, const std::filesystem::path& name);

/// A file with every key, each with meaning, unit, range and source: at its default, or as an
/// example where there is none.
std::string example_population_file();

}  // namespace phytobench
