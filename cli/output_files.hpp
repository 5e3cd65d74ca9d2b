// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench::cli {

/// Throws where a file, or standard output, cannot be written: before minutes are spent on what
/// goes there. Empty names are passed over, missing folders are made, and no file is left.
/// InputError for a folder, for what is no ordinary file, and for one name given for two documents;
/// EnvironmentError where the system refuses.
void refuse_unwritable_files(const std::vector<std::string>& names);

}  // namespace phytobench::cli
