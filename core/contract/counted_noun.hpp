// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace phytobench {

/// "1 segment", "0 segments". `many` is for nouns that do more than take an s: "vertices".
std::string counted_noun(std::uint64_t count, std::string_view one, std::string_view many = {});

}  // namespace phytobench
