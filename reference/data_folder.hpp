// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// The folder with the paper files and report templates: $PHYTOBENCH_DATA, or that of the running
/// program. Throws EnvironmentError if neither is there.
std::filesystem::path data_folder();

/// The first folder with papers that is called `share`, as a build has it, or `share/phytobench`,
/// as an installation has it (bin/phytobench), and lies beside the program or a folder above it.
/// Nothing if there is none.
std::optional<std::filesystem::path> data_folder_of_program(const std::filesystem::path& program);

/// The folder of one paper. Throws InputError for an unknown key.
std::filesystem::path paper_folder(const std::string& key);

/// The TOML files of one kind ("claims", "errata") of a paper: `<kind>.toml`, or all in the folder
/// `<kind>/` in the order of their names, for works with too many entries for one. Throws
/// InputError if there are none, or both.
std::vector<std::filesystem::path> paper_files(const std::string& key, const std::string& kind);

}  // namespace phytobench
