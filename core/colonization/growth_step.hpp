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

  explicit GrowthStep(const GrowthParameters& parameters);

  /// Appends the children to `skeleton` and to `nodes`; node i of `nodes` is skeleton node first +
  /// i.
  Counts grow(std::span<const Vector3> points, const Assignment& assignment, std::int32_t first,
              std::vector<SearchableNode>& nodes, Skeleton& skeleton);

 private:
  Counts sum_attractions(std::span<const Vector3> points, const Assignment& assignment,
                         const std::vector<SearchableNode>& nodes);

  GrowthParameters parameters_;
  DirectionLimit limit_;
  Perception perception_;
  std::vector<Vector3> sum_;              // per node
  std::vector<std::uint8_t> is_growing_;  // per node
  std::vector<NodeIndex> growing_;        // in order of first attraction point
};

}  // namespace phytobench
