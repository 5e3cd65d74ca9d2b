// SPDX-License-Identifier: MIT
// Tests of angles state them in degrees.
#pragma once

#include <numbers>

namespace phytobench {

inline constexpr double degree = std::numbers::pi / 180.0;  // rad

}  // namespace phytobench
