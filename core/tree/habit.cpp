// SPDX-License-Identifier: MIT
#include "core/tree/habit.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

/// Children of every node.
std::vector<std::int32_t> child_counts(const Skeleton& skeleton) {
  std::vector<std::int32_t> counts(skeleton.node_count(), 0);
  for (std::size_t i = 1; i < counts.size(); ++i)
    ++counts[static_cast<std::size_t>(skeleton.parents()[i])];
  return counts;
}

}  // namespace

std::size_t branching_count(const Skeleton& skeleton) {
  const std::vector<std::int32_t> children = child_counts(skeleton);
  return static_cast<std::size_t>(
      std::count_if(children.begin(), children.end(), [](std::int32_t n) { return n > 1; }));
}

double mean_turn_rad(const Skeleton& skeleton, std::int32_t first_node) {
  PHYTOBENCH_EXPECT(first_node >= 0);
  const std::vector<std::int32_t> children = child_counts(skeleton);
  double sum = 0.0;
  std::size_t turns = 0;
  for (std::size_t i = 1; i < children.size(); ++i) {
    const std::int32_t parent = skeleton.parents()[i];
    if (parent < std::max(first_node, 1) || children[static_cast<std::size_t>(parent)] != 1)
      continue;
    const Vector3& lower = skeleton.position(skeleton.parents()[static_cast<std::size_t>(parent)]);
    const Vector3 before = skeleton.position(parent) - lower;
    const Vector3 after = skeleton.positions()[i] - skeleton.position(parent);
    sum += std::atan2(norm(cross(before, after)), dot(before, after));
    ++turns;
  }
  return turns == 0 ? 0.0 : sum / static_cast<double>(turns);
}

double trunk_share(const Skeleton& skeleton, std::span<const double> radii, double y) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  double all = 0.0, thickest = 0.0;
  for (std::size_t i = 1; i < radii.size(); ++i) {
    const double upper = skeleton.positions()[i].y;
    const double lower = skeleton.position(skeleton.parents()[i]).y;
    if (std::min(upper, lower) > y || std::max(upper, lower) <= y) continue;
    const double area = radii[i] * radii[i];  // but for pi, which the share does not need
    all += area;
    thickest = std::max(thickest, area);
  }
  return all > 0.0 ? thickest / all : 0.0;
}

std::vector<CrownPart> crown_parts(const Skeleton& skeleton, std::int32_t crown_root,
                                   std::size_t parts) {
  const auto root = static_cast<std::size_t>(crown_root);
  PHYTOBENCH_EXPECT(parts > 0 && crown_root >= 0 && root < skeleton.node_count());
  const std::vector<std::int32_t> depths = node_depths(skeleton), children = child_counts(skeleton);
  const auto edges_to = [&](std::size_t node) {
    PHYTOBENCH_EXPECT(depths[node] >= depths[root]);
    return static_cast<std::size_t>(depths[node] - depths[root]);
  };
  std::size_t deepest = 0;
  for (std::size_t i = root; i < depths.size(); ++i) deepest = std::max(deepest, edges_to(i));
  std::vector<CrownPart> crown(parts);
  for (std::size_t i = root; i < depths.size(); ++i) {
    CrownPart& part = crown[edges_to(i) * parts / (deepest + 1)];
    part.inner_nodes += children[i] > 0;
    part.branchings += children[i] > 1;
  }
  return crown;
}

}  // namespace phytobench
