// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/contract/text_file.hpp"

namespace phytobench::cli {

/// Throws where a file, or standard output, cannot be written: before minutes are spent on what
/// goes there. Empty names are passed over, and no file is left.
/// InputError for a folder, for what is no ordinary file, for one in a folder that is not there,
/// and for one name given for two documents; EnvironmentError where the system refuses, or nobody
/// may write to the file.
void refuse_unwritable_files(const std::vector<std::string>& names);

/// write_files_atomically() of models and pictures, which bring files of their own that no option
/// names: materials and textures. InputError where two have one name, EnvironmentError for one that
/// nobody may write to.
void write_new_files(const std::vector<FileContent>& files);

}  // namespace phytobench::cli
