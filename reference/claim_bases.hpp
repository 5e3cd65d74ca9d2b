// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace phytobench {

/// What the verdict on a claim can rest on (`basis` of a claim), in the order of every table.
inline constexpr std::array<std::string_view, 4> claim_bases = {"paper", "author-published",
                                                                "assumed", "fitted"};

}  // namespace phytobench
