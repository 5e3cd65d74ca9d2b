// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "core/component_graph/component_values.hpp"
#include "core/component_graph/material.hpp"

namespace phytobench {

/// In the order of Surface.
inline constexpr std::array<std::string_view, 3> surface_words{"bark", "leaf", "plain"};

/// The material that two keys of an instance give: the word of a surface, and a colour.
inline Material material_of(const ComponentValues& values, std::size_t surface_key,
                            std::size_t colour_key) {
  return {static_cast<Surface>(values.choice(surface_key)), values.colour(colour_key)};
}

}  // namespace phytobench
