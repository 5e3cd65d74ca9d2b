// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace phytobench {

/// The folder with the paper files and report templates: $PHYTOBENCH_DATA, or `share` beside the
/// program. Throws EnvironmentError if neither is there.
std::filesystem::path data_folder();

/// The folder of one paper. Throws InputError for an unknown key.
std::filesystem::path paper_folder(const std::string& key);

}  // namespace phytobench
