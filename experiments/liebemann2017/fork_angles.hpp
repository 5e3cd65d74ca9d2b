// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "core/tree/branches.hpp"

namespace phytobench::experiments::liebemann2017 {

/// Mean angle between the edges to successors of one node, in degrees, over all pairs but those of
/// the root, whose angles the reduction keeps; 0 without forks.
inline double mean_fork_angle_deg(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  double sum = 0.0;
  std::int64_t pairs = 0;
  for (std::int32_t v = 1; v < static_cast<std::int32_t>(skeleton.node_count()); ++v) {
    const auto successors = children.of(v);
    for (std::size_t i = 0; i < successors.size(); ++i)
      for (std::size_t j = i + 1; j < successors.size(); ++j) {
        const Vector3 a = skeleton.position(successors[i]) - skeleton.position(v),
                      b = skeleton.position(successors[j]) - skeleton.position(v);
        sum += std::atan2(norm(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
        ++pairs;
      }
  }
  return pairs > 0 ? sum / static_cast<double>(pairs) : 0.0;
}

}  // namespace phytobench::experiments::liebemann2017
