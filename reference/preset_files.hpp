// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace phytobench {

/// A parameter file that comes with the suite: of a paper's figure, or of our own.
struct PresetFile {
  std::string name;     ///< that of the file, "figure-43-middle"; unique
  std::string summary;  ///< the file's first comment
  std::filesystem::path file;
};

/// The TOML files in the folder `kind` ("trees", "stands") of the suite and of every paper, in the
/// order of their names.
std::vector<PresetFile> preset_files(const std::string& kind);

/// The file of the first of these names that is there. Throws InputError with the name closest to
/// the first, and with what lists them.
std::filesystem::path preset_file_named(const std::string& kind,
                                        std::span<const std::string> names);

}  // namespace phytobench
