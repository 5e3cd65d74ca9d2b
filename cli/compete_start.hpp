// SPDX-License-Identifier: MIT
// What a run of `phytobench compete` starts from.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/commands.hpp"
#include "core/contract/text_file.hpp"
#include "core/population/population.hpp"
#include "core/population/population_settings.hpp"

namespace phytobench::cli {

struct CompeteStart {
  PopulationParameters parameters;
  std::vector<StartPlant> plants;
  std::vector<Setting> settings;     ///< all that the files of the run depend on
  std::vector<std::uint64_t> count;  ///< plants by species
  /// With --out, what the run is repeated from, under its names in that folder: parameters.toml,
  /// the files that it names, and those of --plants. The file of --plants has a name of its own
  /// there, "start-" before it where that is taken. What parameters.toml names by an absolute path
  /// or through ".." is found or missed where that leads, and is not here.
  std::vector<FileContent> inputs;
};

/// Reads all files. Throws InputError for options that do not fit each other, for files, and for a
/// run without a plant.
CompeteStart read_start(const CompeteOptions& options);

}  // namespace phytobench::cli
