// SPDX-License-Identifier: MIT
// What the numbers of competition may be, once for files and for programs.
#pragma once

#include "core/contract/parameter_keys.hpp"

namespace phytobench::competition_ranges {

inline constexpr NumberRange above_share{.high = 1.0};
inline constexpr NumberRange asymmetry_exponent{.high = 1e6, .infinity_is_allowed = true};
inline constexpr NumberRange light_constant{.high = 1e6, .low_is_allowed = false};
inline constexpr NumberRange field_at_rim{
    .high = 1.0, .low_is_allowed = false, .high_is_allowed = false};
inline constexpr NumberRange crown_opacity{.high = 1.0};
inline constexpr NumberRange root_rank{.high = 1.0};
inline constexpr NumberRange open_ground_stress{.high = 1e6};

}  // namespace phytobench::competition_ranges
