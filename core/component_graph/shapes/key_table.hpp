// SPDX-License-Identifier: MIT
// What the key tables of the kinds of components have in common.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/component_graph/component_key.hpp"

namespace phytobench {

/// Sources of keys.
inline constexpr std::string_view in_section_4 = "[Lintermann1997] sec. 4";
inline constexpr std::string_view in_section_5 = "[Lintermann1997] sec. 5.1";
inline constexpr std::string_view own_choice = "own";

/// Lengths are in one free unit. Far below what breaks a mesh, so that scales can multiply them.
inline constexpr double largest_length = 1e9;
inline constexpr NumberRange lengths{.low = 0.0, .high = largest_length};
inline constexpr NumberRange positive_lengths{
    .low = 0.0, .high = largest_length, .low_is_allowed = false};
inline constexpr NumberRange signed_lengths{.low = -largest_length, .high = largest_length};
inline constexpr NumberRange scales{.low = 0.0, .high = 1e6, .low_is_allowed = false};
inline constexpr NumberRange shares{.low = 0.0, .high = 1.0};
/// Degrees, for angles that may go around many times.
inline constexpr NumberRange turns{.low = -1e6, .high = 1e6};
inline constexpr NumberRange child_counts{.low = 0.0, .high = 1e6, .whole = true};
inline constexpr NumberRange corner_counts{.low = 3.0, .high = 1000.0, .whole = true};
inline constexpr NumberRange piece_counts{.low = 1.0, .high = 10000.0, .whole = true};

/// One table after the other.
template <std::size_t A, std::size_t B>
constexpr std::array<ComponentKey, A + B> joined(const std::array<ComponentKey, A>& first,
                                                 const std::array<ComponentKey, B>& second) {
  std::array<ComponentKey, A + B> all{};
  for (std::size_t i = 0; i < A; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < B; ++i) all[A + i] = second[i];
  return all;
}

}  // namespace phytobench
