// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace phytobench {

/// Where a program that can be run is, as an absolute path: looked for on PATH if there is no '/'
/// in its name. Nothing if it is missing.
std::optional<std::filesystem::path> found_program(const std::string& program);

}  // namespace phytobench
