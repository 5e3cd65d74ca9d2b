// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace phytobench {

/// More points than this are taken for a slip of the keyboard: 3 GB for the coordinates alone.
inline constexpr double most_points = 2e8;

/// Throws InputError if a generator would make more than most_points. `advice` says what to change,
/// e.g. "lower the intensity".
void refuse_too_many_points(double expected, std::string_view advice);

}  // namespace phytobench
