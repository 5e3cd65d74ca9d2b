// SPDX-License-Identifier: MIT
// For tests of the checks of plants.
#pragma once

#include <cmath>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// A stem with 60 twigs, each of two edges: a root, a fork, bends and tips.
inline Skeleton brush() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  for (int i = 0; i < 60; ++i) {
    tree.append(1, {std::cos(i), 1.5, std::sin(i)});
    tree.append(static_cast<std::int32_t>(tree.node_count()) - 1,
                {1.5 * std::cos(i), 1.7, 1.5 * std::sin(i)});
  }
  return tree;
}

}  // namespace phytobench
