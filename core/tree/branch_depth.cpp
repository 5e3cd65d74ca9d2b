// SPDX-License-Identifier: MIT
#include "core/tree/branch_depth.hpp"

#include "core/contract/check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

std::vector<std::int32_t> depths_on_finished_tree(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::vector<std::int32_t> depths(skeleton.node_count(), 0);
  for (std::size_t i = 1; i < depths.size(); ++i) {
    const std::int32_t parent = skeleton.parents()[i];
    depths[i] =
        depths[static_cast<std::size_t>(parent)] + (children.of(parent).size() == 1 ? 0 : 1);
  }
  return depths;
}

}  // namespace

void BranchDepths::append(std::int32_t parent) {
  PHYTOBENCH_EXPECT(parent >= Skeleton::no_parent &&
                    (parent == Skeleton::no_parent) == depths_.empty() &&
                    parent < static_cast<std::int32_t>(depths_.size()));
  depths_.push_back(parent == Skeleton::no_parent ? 0 : depth_of_next_child(parent));
  children_.push_back(0);
  if (parent != Skeleton::no_parent) ++children_[place_of(parent)];
}

std::vector<std::int32_t> branch_depths(const Skeleton& skeleton, BranchDepthReading reading) {
  if (reading == BranchDepthReading::finished_tree) return depths_on_finished_tree(skeleton);
  BranchDepths depths;
  for (const std::int32_t parent : skeleton.parents()) depths.append(parent);
  return depths.depths();
}

}  // namespace phytobench
