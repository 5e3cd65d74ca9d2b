// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace phytobench {

/// The folder with the paper files and report templates: $PHYTOBENCH_DATA, or `share` beside the
/// program. Throws EnvironmentError if neither is there.
std::filesystem::path data_folder();

/// The folder of one paper. Throws InputError for an unknown key.
std::filesystem::path paper_folder(const std::string& key);

/// The TOML files of one kind ("claims", "errata") of a paper: `<kind>.toml`, or all in the folder
/// `<kind>/` in the order of their names, for works with too many entries for one. Throws
/// InputError if there are none, or both.
std::vector<std::filesystem::path> paper_files(const std::string& key, const std::string& kind);

}  // namespace phytobench
