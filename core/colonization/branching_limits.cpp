// SPDX-License-Identifier: MIT
#include "core/colonization/branching_limits.hpp"

#include "core/contract/check.hpp"

namespace phytobench {

BranchingLimits::BranchingLimits(const GrowthParameters& parameters)
    : limits_(parameters.limits),
      step_length_(parameters.step_length),
      limits_children_(limits_.most_children != GrowthLimits::unlimited ||
                       limits_.most_branch_depth != GrowthLimits::unlimited),
      weighted_(limits_.step_weighting == StepWeighting::by_branch_depth) {
  PHYTOBENCH_EXPECT(limits_.most_children >= 1 && limits_.most_branch_depth >= 0);
  PHYTOBENCH_EXPECT(!weighted_ || (limits_.most_branch_depth > 0 &&
                                   limits_.most_branch_depth != GrowthLimits::unlimited));
}

void BranchingLimits::follow(const Skeleton& skeleton) {
  if (!any()) return;
  PHYTOBENCH_EXPECT(depths_.node_count() <= skeleton.node_count());
  for (std::size_t i = depths_.node_count(); i < skeleton.node_count(); ++i)
    depths_.append(skeleton.parents()[i]);
}

}  // namespace phytobench
