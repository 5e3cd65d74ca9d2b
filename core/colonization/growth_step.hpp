// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/colonization/growth_direction.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// One growth step: every node with attraction points gets one child ([Brzoska2019] eq. 8 and 9).
/// Shared by all engines, so that the same assignment always gives the same tree: directions are
/// summed in point order, and children are made in the order of the lowest-indexed point that
/// caused them.
class GrowthStep {
 public:
  struct Counts {
    std::size_t associated_points = 0;
    std::size_t suppressed_repeats = 0;  ///< children not made because one stands there already
  };

  explicit GrowthStep(const GrowthParameters& parameters, int threads = 1);

  /// Appends the children to `skeleton` and to `nodes`; node i of `nodes` is skeleton node first +
  /// i.
  Counts grow(std::span<const Vector3> points, const Assignment& assignment, std::int32_t first,
              std::vector<SearchableNode>& nodes, Skeleton& skeleton);

 private:
  /// What an associated point adds to its node's sum.
  struct Pull {
    Vector3 towards;
    NodeIndex node;  ///< no_node: given up after the search
  };
  /// A node with points, and the sum of their pulls.
  struct GrowingNode {
    Vector3 sum;
    NodeIndex node;
  };
  enum class Fate : std::uint8_t { grows, repeat, no_direction };
  struct Child {
    SearchableNode node;
    Fate fate;
  };

  void find_pulls(std::span<const Vector3> points, const Assignment& assignment,
                  const std::vector<SearchableNode>& nodes);
  Counts sum_pulls(std::size_t node_count);
  void find_children(std::int32_t first, const std::vector<SearchableNode>& nodes,
                     const Skeleton& skeleton);
  Child child_of(const GrowingNode& parent, std::int32_t first,
                 const std::vector<SearchableNode>& nodes, const Skeleton& skeleton) const;

  GrowthParameters parameters_;
  int threads_;
  DirectionLimit limit_;
  Perception perception_;
  std::vector<PointIndex> associated_;  // points that have a node, ascending
  std::vector<Pull> pulls_;             // of the associated points
  std::vector<std::int32_t> place_;     // per node its place in growing_, or not_growing
  std::vector<GrowingNode> growing_;    // in order of first attraction point
  std::vector<Child> children_;         // of the growing nodes
};

}  // namespace phytobench
