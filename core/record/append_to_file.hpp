// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace phytobench {

/// Appends to a file that has `size` bytes and waits until it is on the disk. Throws
/// EnvironmentError; the file is as long as it was then.
void append_or_restore(const std::filesystem::path& file, std::string_view text,
                       std::uintmax_t size);

}  // namespace phytobench
