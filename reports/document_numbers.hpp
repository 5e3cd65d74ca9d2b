// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace phytobench {

/// A number without decimals, in groups of three digits.
std::string with_thousands(double value);

/// A measured time in the unit that suits it: "12 us", "3.45 ms", "6.7 s".
std::string shown_seconds(double seconds);

/// A time as a reader plans with it: "under 1 s", "12 s", "4 min", "2.5 h".
std::string rough_seconds(double seconds);

/// "1 claim", "2 claims".
std::string counted(std::size_t count, std::string_view one, std::string_view several = "");

}  // namespace phytobench
