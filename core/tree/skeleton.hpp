// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "core/geometry/vector3.hpp"
#include "core/memory/large_array.hpp"

namespace phytobench {

/// A branching structure: nodes joined to their parents by straight edges. Node 0 is the root and
/// every parent precedes its children.
class Skeleton {
 public:
  static constexpr std::int32_t no_parent = -1;

  explicit Skeleton(const Vector3& root) { append(no_parent, root); }

  /// Appends a node and returns its index. `parent` must exist already (no_parent only for the
  /// root).
  std::int32_t append(std::int32_t parent, const Vector3& position);

  /// Makes room for so many nodes: address space, and memory only where nodes come to lie.
  void reserve(std::size_t node_count);

  std::size_t node_count() const { return positions_.size(); }
  std::size_t edge_count() const { return positions_.size() - 1; }
  const LargeVector<Vector3>& positions() const { return positions_; }
  const LargeVector<std::int32_t>& parents() const { return parents_; }
  const Vector3& position(std::int32_t node) const {
    return positions_[static_cast<std::size_t>(node)];
  }

  /// Whether `parent` already has a child exactly at `position` (equal coordinates, no tolerance).
  bool has_child_at(std::int32_t parent, const Vector3& position) const;

  /// Has the processor fetch what has_child_at() will need.
  void prefetch_children(std::int32_t parent) const {
    __builtin_prefetch(&newest_child_[static_cast<std::size_t>(parent)]);
  }

 private:
  LargeVector<Vector3> positions_;
  LargeVector<std::int32_t> parents_;
  LargeVector<std::int32_t> newest_child_;   // per node, or -1
  LargeVector<std::int32_t> older_sibling_;  // per node, or -1
};

/// Nodes without children; the root alone counts as none.
std::size_t tip_count(const Skeleton& skeleton);

/// y of the highest node ([Brzoska2019] sec. 5.2.1, GetTreeHeight).
double highest_y(const Skeleton& skeleton);

/// Greatest number of edges from the root to any node.
std::size_t edge_depth(const Skeleton& skeleton);

/// 64-bit FNV-1a over all positions (bit patterns) and parents, as 16 hexadecimal digits. Equal
/// hashes stand for equal trees, node for node and bit for bit.
std::string tree_hash(const Skeleton& skeleton);

}  // namespace phytobench
