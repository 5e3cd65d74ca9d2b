// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/colonization/growth_parameters.hpp"
#include "core/tree/branch_depth.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Which nodes of a growing tree may get another child, and how far away ([Liebemann2017] sec.
/// 3.5: max_grad, max_Z, weighted growth). Follows the tree only if something is asked of it.
class BranchingLimits {
 public:
  /// Weighting demands 0 < most_branch_depth < unlimited.
  explicit BranchingLimits(const GrowthParameters& parameters);

  /// Whether any node can be refused a child, or steps differ. If not, follow() does nothing and
  /// nothing else may be called.
  bool any() const { return limits_children_ || weighted_; }

  /// Takes note of the nodes that `skeleton` has got since the last call. Always the same tree.
  void follow(const Skeleton& skeleton);

  bool allow_child(std::int32_t node) const {
    return !limits_children_ || (depths_.children(node) < limits_.most_children &&
                                 depths_.depth_of_next_child(node) <= limits_.most_branch_depth);
  }

  /// Between `node` and its next child; by the branch depth of `node`, not of the child.
  double step_length(std::int32_t node) const {
    if (!weighted_) return step_length_;
    return step_length_ *
           (2.0 - static_cast<double>(depths_.depth(node)) / limits_.most_branch_depth);
  }

 private:
  GrowthLimits limits_;
  double step_length_;
  bool limits_children_;
  bool weighted_;
  BranchDepths depths_;
};

}  // namespace phytobench
