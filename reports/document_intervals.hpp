// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/statistics/median_of_rounds.hpp"

namespace phytobench {

/// Where a column or a note says what such ends are.
inline constexpr const char* ends_of_medians = "95 % interval, or range of fewer than six rounds";

/// The two ends with a word on what they are, where they are no interval: "1 ms to 2 ms" from six
/// rounds on, "1 ms to 2 ms in 3 rounds" of fewer.
std::string shown_ends(const MedianOfRounds& median, const std::string& low,
                       const std::string& high);

}  // namespace phytobench
