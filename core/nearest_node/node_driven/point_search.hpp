// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// A point and the node that it belongs to from now on; of a tie only if its node so far has a
/// higher number.
struct Association {
  PointIndex point;
  NodeIndex node;
  bool tie;
};

/// A static index over the live points, asked by nodes: which points do you come nearer to than any
/// node before? It remembers every point's smallest squared distance so far.
class PointSearch {
 public:
  virtual ~PointSearch() = default;

  /// Appends the points that one of `nodes`, numbered from `first`, perceives and is nearer to than
  /// every node before; also ties among `nodes`. To be applied in that order.
  virtual void associate(std::span<const SearchableNode> nodes, NodeIndex first,
                         std::vector<Association>& found) = 0;

  /// Removes the live points with a squared distance <= squared_kill to one of `killers`, and
  /// appends them.
  virtual void remove(std::span<const SearchableNode> killers, double squared_kill,
                      std::vector<PointIndex>& removed) = 0;

  /// Bytes held for the points.
  virtual std::size_t bytes() const = 0;

  virtual WorkCounters counters() const = 0;
};

}  // namespace phytobench
