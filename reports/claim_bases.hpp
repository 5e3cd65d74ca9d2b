// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace phytobench {

/// What the verdict on a claim can rest on (`basis` of a claim), in the order of every table.
inline constexpr std::array claim_bases = {"paper", "author-published", "assumed", "fitted"};

}  // namespace phytobench
