// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// The whole file. Throws InputError if it does not exist, is a folder, cannot be read or is larger
/// than `most_bytes`.
std::string read_text_file(const std::filesystem::path& file,
                           std::uintmax_t most_bytes = 64u << 20);

/// Writes to a temporary name beside the file and renames it, so that a reader sees the old content
/// or the new, never half of it. Creates missing folders. Throws EnvironmentError; nothing is left
/// behind then.
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

struct FileContent {
  std::filesystem::path file;
  std::string content;
};

/// The same for files that belong together: all are written under temporary names before the first
/// is renamed, so that a full disk or an unwritable folder leaves what was there before.
void write_files_atomically(const std::vector<FileContent>& files);

/// Makes the folder with its parents. Throws EnvironmentError.
void make_folder(const std::filesystem::path& folder);

}  // namespace phytobench
