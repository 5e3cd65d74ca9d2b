// SPDX-License-Identifier: MIT
// Files without a name: what programs read and write that nobody has to wait for, as for a pipe.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace phytobench {

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Holds the text, at whose beginning it stands. Programs that are started do not get it. Throws
/// EnvironmentError, which begins with `failure`.
TemporaryFile temporary_file(std::string_view text, std::string_view failure);

/// All of the file; leaves it at its end.
std::string content_of(const TemporaryFile& file);

}  // namespace phytobench
