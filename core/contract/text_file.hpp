// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace phytobench {

/// The whole file. Throws InputError if it does not exist, is a folder, cannot be read or is larger
/// than `most_bytes`.
std::string read_text_file(const std::filesystem::path& file,
                           std::uintmax_t most_bytes = 64u << 20);

/// Writes to a temporary name beside the file and renames it, so that a reader sees the old content
/// or the new, never half of it. Creates missing folders. Throws EnvironmentError; nothing is left
/// behind then.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// Makes the folder with its parents. Throws EnvironmentError.
void make_folder(const std::filesystem::path& folder);

}  // namespace phytobench
