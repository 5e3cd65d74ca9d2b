// SPDX-License-Identifier: MIT
// What the tests of space colonization share: how a crown is grown, and a small tree.
#pragma once

#include <numbers>
#include <string_view>

#include "core/colonization/growth.hpp"
#include "core/colonization/tree_parameters.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {

inline constexpr double half_angle_rad = 80.0 * std::numbers::pi / 180.0;

inline GrowthResult grow(const Seedling& seedling, const GrowthRun& run = {},
                         std::string_view engine = "squared_scan") {
  const auto made = engine_named(engine).create();
  return grow_crown(seedling, *made, run);
}

/// The thesis' start settings with a small crown, quick to sample: 1039 points, some 240 crown
/// edges.
inline TreeParameters small_tree() {
  TreeParameters parameters;
  parameters.cloud.radii = {2.0, 2.8, 1.8};
  return parameters;
}

inline TreeParameters parsed_tree(std::string_view text) {
  return parse_tree_parameters(text, "tree.toml");
}

}  // namespace phytobench
