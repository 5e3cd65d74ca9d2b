// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace phytobench {

/// A file for a model that comes with the suite: of a paper's figure, or of our own.
struct PresetFile {
  std::string name;     ///< that of the file, "figure-43-middle"; unique in its kind
  std::string summary;  ///< the file's first comment
  std::filesystem::path file;
};

/// The files in the folder `kind` ("trees", "stands") of the suite and of every paper whose names
/// end like this, in the order of their names.
std::vector<PresetFile> preset_files(const std::string& kind,
                                     const std::string& extension = ".toml");

/// The file of the first of these names that is there. Throws InputError with the name closest to
/// the first, and with what lists them.
std::filesystem::path preset_file_named(const std::string& kind, std::span<const std::string> names,
                                        const std::string& extension = ".toml");

}  // namespace phytobench
