// SPDX-License-Identifier: MIT
#include "core/tree/branch_angle_reduction.hpp"

#include "core/contract/check.hpp"

namespace phytobench {

Skeleton reduce_branch_angles(const Skeleton& skeleton, double share) {
  PHYTOBENCH_EXPECT(share >= 0.0 && share < 1.0);
  if (share == 0.0) return skeleton;
  Skeleton reduced(skeleton.positions()[0]);
  reduced.reserve(skeleton.node_count());
  for (std::size_t i = 1; i < skeleton.node_count(); ++i) {
    const std::int32_t parent = skeleton.parents()[i];
    const Vector3& from = skeleton.positions()[i];
    reduced.append(parent, from + share * (skeleton.position(parent) - from));
  }
  return reduced;
}

}  // namespace phytobench
