// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// When the children of a node's parent are counted ([Liebemann2017] eq. 3.5).
enum class BranchDepthReading {
  at_creation,    ///< as the text has it: when the node is made, and never again
  finished_tree,  ///< when the tree is finished
};

/// Branch depth Z of every node: 0 at the root; that of its parent if the parent has exactly one
/// child; one more if it has several ([Liebemann2017] eq. 3.5). At creation the first child of a
/// fork keeps its parent's depth; on the finished tree all children of a fork are one deeper.
/// Nodes are made in the order of their indices.
std::vector<std::int32_t> branch_depths(const Skeleton& skeleton, BranchDepthReading reading);

/// The same at creation, for a tree that is still growing.
class BranchDepths {
 public:
  /// The next node; `parent` is one that is known, or Skeleton::no_parent for the first.
  void append(std::int32_t parent);

  std::size_t node_count() const { return depths_.size(); }
  std::int32_t children(std::int32_t node) const { return children_[place_of(node)]; }
  std::int32_t depth(std::int32_t node) const { return depths_[place_of(node)]; }
  /// Of the child that `node` would get now.
  std::int32_t depth_of_next_child(std::int32_t node) const {
    return depth(node) + (children(node) == 0 ? 0 : 1);
  }
  const std::vector<std::int32_t>& depths() const { return depths_; }

 private:
  static std::size_t place_of(std::int32_t node) { return static_cast<std::size_t>(node); }

  std::vector<std::int32_t> depths_;
  std::vector<std::int32_t> children_;  // of each node, so far
};

}  // namespace phytobench
