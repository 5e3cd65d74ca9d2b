// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace phytobench {

/// SHA-256 of all that a program or shared library is when it runs: name, flags, size and content
/// of each section that is loaded into memory, in the file's order. Notes (a build's number among
/// them), symbol tables and debug information do not count, so that equal sources give equal
/// digests wherever they were built, as long as no path is compiled in. Throws InputError for
/// anything but an undamaged 64-bit ELF file of this machine's byte order.
std::string program_digest(const std::filesystem::path& file);

/// The same from the file's content; `name` stands for the file in messages.
std::string program_digest(std::string_view content, std::string_view name);

}  // namespace phytobench
