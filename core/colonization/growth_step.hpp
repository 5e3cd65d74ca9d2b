// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/colonization/branching_limits.hpp"
#include "core/colonization/growth_direction.hpp"
#include "core/memory/large_array.hpp"
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
    std::size_t assigned_points = 0;     ///< by the engine
    std::size_t associated_points = 0;   ///< those of them that their node perceives
    std::size_t suppressed_repeats = 0;  ///< children not made because one stands there already
    std::size_t refused_children = 0;    ///< children not made because of the limits
  };

  explicit GrowthStep(const GrowthParameters& parameters, int threads = 1);

  /// Makes room for what is kept of so many nodes.
  void reserve(std::size_t node_count);

  /// Appends the children to `skeleton` and to `nodes`; node i of `nodes` is skeleton node first +
  /// i.
  Counts grow(std::span<const Vector3> points, const Assignment& assignment, std::int32_t first,
              LargeVector<SearchableNode>& nodes, Skeleton& skeleton);

 private:
  /// An associated point and the place of its node among the growing ones.
  struct Attracting {
    PointIndex point;
    std::int32_t place;
  };
  /// A node with points, and the sum of their pulls.
  struct GrowingNode {
    Vector3 sum;
    NodeIndex node;
    PointIndex first_point;
    std::uint32_t points;
    bool changed;  ///< since its last step
  };
  enum class Fate : std::uint8_t { grows, repeat, no_direction, refused };
  struct Child {
    SearchableNode node;
    NodeIndex parent;
    PointIndex first_point;  ///< of its parent
  };
  /// What is remembered of a node's last step.
  struct LastStep {
    std::uint32_t points = 0;
    Fate fate = Fate::grows;
  };
  /// Points that have a node, ascending, and their nodes.
  struct Associated {
    std::vector<PointIndex> points;
    std::vector<NodeIndex> nodes;
  };
  /// Some of the nodes, and everything that comes of them: whoever works on it needs nobody else.
  struct Share {
    Associated associated;               ///< with one of these nodes
    std::vector<Attracting> attracting;  ///< those that count; then those of changed nodes
    std::vector<GrowingNode> growing;    ///< in order of first attraction point
    std::vector<Child> children;         ///< in the same order
    Counts counts;
  };

  void find_nodes(const Assignment& assignment);
  const Associated& associated_of(Share& share, std::size_t number) const;
  void grow_share(Share& share, const Associated& associated, std::span<const Vector3> points,
                  std::int32_t first, std::span<const SearchableNode> nodes,
                  const Skeleton& skeleton);
  void find_growing(Share& share, const Associated& associated, std::span<const Vector3> points,
                    std::span<const SearchableNode> nodes);
  bool is_given_up(const Vector3& point, const SearchableNode& node) const;
  void note_changes(Share& share) const;
  void sum_pulls(Share& share, std::span<const Vector3> points,
                 std::span<const SearchableNode> nodes) const;
  void find_children(Share& share, std::int32_t first, std::span<const SearchableNode> nodes,
                     const Skeleton& skeleton);
  Fate grow_child(const GrowingNode& parent, std::int32_t first, const SearchableNode& node,
                  const Skeleton& skeleton, std::vector<Child>& children) const;
  void append_children(std::int32_t first, LargeVector<SearchableNode>& nodes, Skeleton& skeleton);

  GrowthParameters parameters_;
  int threads_;
  DirectionLimit limit_;
  Perception perception_;
  BranchingLimits limits_;
  std::vector<Associated> associated_;  // one after the other all there are
  std::vector<Share> shares_;
  std::vector<std::size_t> next_child_;  // per share
  LargeVector<std::int32_t> place_;      // per node its place among the growing, or not_growing
  LargeVector<LastStep> last_step_;      // per node
};

}  // namespace phytobench
