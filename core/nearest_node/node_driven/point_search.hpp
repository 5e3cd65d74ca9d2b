// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// A static index over the live points, asked by nodes: which points do you come nearer to than any
/// node before? It remembers every point's smallest squared distance so far.
class PointSearch {
 public:
  virtual ~PointSearch() = default;

  /// Gives the points that one of `nodes`, numbered from `first`, perceives and is nearer to than
  /// every node before the nearest of them, at equal distances the first; appends those that had
  /// no_node to `reached`, in any order.
  virtual void associate(std::span<const SearchableNode> nodes, NodeIndex first,
                         std::span<NodeIndex> node_of_point, std::vector<PointIndex>& reached) = 0;

  /// Removes the live points with a squared distance <= squared_kill to one of `killers`, and
  /// appends them.
  virtual void remove(std::span<const SearchableNode> killers, double squared_kill,
                      std::vector<PointIndex>& removed) = 0;

  /// Bytes held for the points.
  virtual std::size_t bytes() const = 0;

  virtual WorkCounters counters() const = 0;
};

}  // namespace phytobench
