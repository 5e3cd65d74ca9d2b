// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace phytobench::cli {

/// The sources that this program was built from: the nearest folder above it that holds them, or
/// the current folder for a program that was installed elsewhere.
std::filesystem::path source_tree();

}  // namespace phytobench::cli
