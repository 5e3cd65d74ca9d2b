// SPDX-License-Identifier: MIT
// Branch depths beside the literal loops for eq. 3.5 of [Liebemann2017].
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/liebemann2017/limited_growth.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::experiments::liebemann2017 {

/// Nodes of which both have another one.
inline std::int64_t differences(const std::vector<std::int32_t>& found,
                                const std::vector<int>& expected) {
  std::int64_t different = 0;
  for (std::size_t v = 0; v < expected.size(); ++v) different += found.at(v) != expected[v];
  return different;
}

/// Nodes with another branch depth than the literal loops give, in both readings.
inline std::int64_t other_branch_depths(const Skeleton& skeleton) {
  const oracles::liebemann2017::TreeGraph G(
      std::vector<int>(skeleton.parents().begin(), skeleton.parents().end()));
  return differences(branch_depths(skeleton, BranchDepthReading::at_creation),
                     oracles::liebemann2017::branch_depths_at_creation(G)) +
         differences(branch_depths(skeleton, BranchDepthReading::finished_tree),
                     oracles::liebemann2017::branch_depths_when_finished(G));
}

}  // namespace phytobench::experiments::liebemann2017
