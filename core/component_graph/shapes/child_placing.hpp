// SPDX-License-Identifier: MIT
// What all multipliers let their users set for each child ([Lintermann1997] sec. 4).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "core/component_graph/component_values.hpp"
#include "core/component_graph/frame.hpp"
#include "core/component_graph/shapes/key_table.hpp"

namespace phytobench {

/// Positions of the keys in the table of a kind.
struct ChildPlacingKeys {
  std::size_t azimuth = 0;
  std::size_t tilt = 0;
  std::size_t roll = 0;
  std::size_t scale = 0;
};

/// Those four in that order, the tilt with its default.
constexpr std::array<ComponentKey, 4> child_placing_keys(std::string_view tilt_meaning,
                                                         std::string_view tilt_text, double tilt) {
  return {{
      {"azimuth", "degrees", "added to the direction of each child around the axis", in_section_5,
       "0.0", RangedNumber{turns, 0.0, RangeOver::children}},
      {"tilt", "degrees", tilt_meaning, in_section_5, tilt_text,
       RangedNumber{turns, tilt, RangeOver::children}},
      {"roll", "degrees", "turn of each child about its own axis", own_choice, "0.0",
       RangedNumber{turns, 0.0, RangeOver::children}},
      {"scale", "1", "size of each child and all that hangs below it", in_section_5, "1.0",
       RangedNumber{scales, 1.0, RangeOver::children}},
  }};
}

/// The azimuth of child `child.i`, in degrees: `regular_deg` with what the key adds to it.
double child_azimuth(const ComponentValues& values, const ChildPlacingKeys& keys,
                     const SiblingNumber& child, double regular_deg);

/// The frame at `origin` of a child at an azimuth, tilted by `regular_tilt_deg` and the key's tilt,
/// rolled and scaled.
Frame child_frame(const ComponentValues& values, const ChildPlacingKeys& keys,
                  const SiblingNumber& child, const Vector3& origin, double azimuth_deg,
                  double regular_tilt_deg = 0.0);

/// Child i of frames.size().
inline SiblingNumber child_number(std::size_t position, std::span<const Frame> frames) {
  return {static_cast<std::uint32_t>(position + 1), static_cast<std::uint32_t>(frames.size())};
}

}  // namespace phytobench
