// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// "; did you mean 'x'?" with the candidate of fewest edits, or nothing if none is close.
std::string did_you_mean(std::string_view wrong, std::span<const std::string> candidates);

}  // namespace phytobench
