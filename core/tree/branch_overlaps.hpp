// SPDX-License-Identifier: MIT
// Branches that run into each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Two edges, named by their upper nodes, whose tubes meet although the edges have no node in
/// common.
struct BranchOverlap {
  std::int32_t lower_index = 0;    ///< the smaller of the two nodes
  std::int32_t higher_index = 0;   ///< the larger
  std::int32_t edges_between = 0;  ///< edges from one to the other along the branches, >= 1: small
                                   ///< next to a branching, where thick branches cannot but meet
  double distance = 0.0;           ///< between their centre lines, length units
};

/// All pairs of edges nearer to each other than the sum of their radii (per node, of the edge below
/// it), sorted by their indices.
std::vector<BranchOverlap> branch_overlaps(const Skeleton& skeleton, std::span<const double> radii);

}  // namespace phytobench
