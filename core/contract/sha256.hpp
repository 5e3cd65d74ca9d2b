// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// SHA-256 of the bytes (FIPS 180-4) as 64 lower-case hexadecimal digits, the form that `sha256sum`
/// prints. Throws EnvironmentError if the library refuses the algorithm.
std::string sha256_hex(std::string_view bytes);

}  // namespace phytobench
