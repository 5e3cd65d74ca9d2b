// SPDX-License-Identifier: MIT
// What a tree looks like, in a few numbers: how densely it branches, how straight its branches are,
// and whether it has a trunk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Nodes with more than one child.
std::size_t branching_count(const Skeleton& skeleton);

/// Mean angle in radians between an edge and the next where a branch goes on without branching,
/// over the nodes from `first_node` on (the crown root leaves out the stem). 0 where nothing goes
/// on.
double mean_turn_rad(const Skeleton& skeleton, std::int32_t first_node);

/// Share of the cross-section area of all branches at height y that the thickest of them has: 1
/// for a trunk alone, small for many equal branches; 0 where there is no branch. Radii per node, of
/// the edge below it.
double trunk_share(const Skeleton& skeleton, std::span<const double> radii, double y);

/// Some of the nodes of a crown.
struct CrownPart {
  std::size_t branchings = 0;   ///< nodes with more than one child
  std::size_t inner_nodes = 0;  ///< nodes with a child: those that could have become a branching

  /// How likely a branch branches at a node; 0 without any.
  double branching_share() const {
    return inner_nodes == 0 ? 0.0
                            : static_cast<double>(branchings) / static_cast<double>(inner_nodes);
  }
};

/// The crown in `parts` > 0 parts of equal range of edges between `crown_root` and the nodes, from
/// the inside to the outside. `crown_root` must exist, and every later node must grow on it.
std::vector<CrownPart> crown_parts(const Skeleton& skeleton, std::int32_t crown_root,
                                   std::size_t parts);

}  // namespace phytobench
