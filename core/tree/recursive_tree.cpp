// SPDX-License-Identifier: MIT
#include "core/tree/recursive_tree.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/geometry/rotation.hpp"

namespace phytobench {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A tree still to be drawn: where it starts, how long its first segment is, how it is turned.
struct Sprout {
  std::int32_t node;
  double size;
  Rotation turned;
};

void check(bool holds, const char* name, const char* allowed) {
  if (!holds) throw InputError(fmt::format("recursive tree: {} must be {}", name, allowed));
}

void check(const RecursiveTreeParameters& p) {
  check(p.size > 0.0 && std::isfinite(p.size), "size", "a number > 0");
  check(p.smallest > 0.0, "smallest", "a number > 0");
  check(p.branches >= 0 && p.branches <= 100, "branches", "between 0 and 100");
  check(p.stem_ratio > 0.0 && p.stem_ratio < 1.0, "stem_ratio", "between 0 and 1");
  check(p.branch_ratio > 0.0 && p.branch_ratio < 1.0, "branch_ratio", "between 0 and 1");
  check(std::isfinite(p.branch_angle_deg) && std::isfinite(p.twist_deg), "an angle", "finite");
}

}  // namespace

RecursiveTree grow_recursive_tree(const RecursiveTreeParameters& p) {
  check(p);
  RecursiveTree tree;
  std::vector<Sprout> waiting{{0, p.size, {}}};
  const Rotation twist = Rotation::about({0, 1, 0}, p.twist_deg * degree);
  while (!waiting.empty()) {
    const Sprout sprout = waiting.back();
    waiting.pop_back();
    if (tree.skeleton.edge_count() >= p.most_segments)
      throw InputError(
          fmt::format("recursive tree: more than {} segments; raise smallest, or lower "
                      "branches or a ratio",
                      p.most_segments));
    const std::int32_t tip = tree.skeleton.append(
        sprout.node, tree.skeleton.position(sprout.node) + sprout.size * sprout.turned({0, 1, 0}));
    if (sprout.size < p.smallest) {
      tree.leaf_nodes.push_back(tip);
      continue;
    }
    const Rotation next = sprout.turned * twist;
    for (std::int32_t i = p.branches; i-- > 0;) {
      const Rotation around = Rotation::about({0, 1, 0}, 360.0 * i / p.branches * degree);
      const Rotation aside = Rotation::about({0, 0, 1}, p.branch_angle_deg * degree);
      waiting.push_back({tip, p.branch_ratio * sprout.size, next * around * aside});
    }
    waiting.push_back({tip, p.stem_ratio * sprout.size, next});
  }
  return tree;
}

}  // namespace phytobench
