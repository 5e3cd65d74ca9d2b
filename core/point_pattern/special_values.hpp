// SPDX-License-Identifier: MIT
// What functions of patterns say where there is no number to say.
#pragma once

#include <limits>

namespace phytobench {

/// Where nothing was seen that a value could be taken from.
inline constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();

/// To what is not there: no other point, no edge.
inline constexpr double infinite_distance = std::numeric_limits<double>::infinity();

}  // namespace phytobench
