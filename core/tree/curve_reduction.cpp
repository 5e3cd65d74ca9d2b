// SPDX-License-Identifier: MIT
#include "core/tree/curve_reduction.hpp"

#include <algorithm>

#include "core/contract/check.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

/// <R1, R2> of [Liebemann2017] eq. 3.6. Never above 1, as rounding could have it; -1 where an edge
/// has no length.
double cosine_between(const Vector3& below, const Vector3& above) {
  const double length_below = norm(below), length_above = norm(above);
  if (!(length_below > 0.0 && length_above > 0.0)) return -1.0;
  return std::min(dot(below / length_below, above / length_above), 1.0);
}

}  // namespace

ReducedSkeleton reduce_curves(const Skeleton& skeleton, const CurveReduction& reduction) {
  PHYTOBENCH_EXPECT(reduction.cosine_above >= -1.0 && reduction.cosine_above <= 1.0);
  const ChildLists children(skeleton);
  ReducedSkeleton reduced;
  reduced.skeleton = Skeleton(skeleton.positions()[0]);
  reduced.skeleton.reserve(skeleton.node_count());
  reduced.node_before = {0};
  reduced.node_after.assign(skeleton.node_count(), ReducedSkeleton::removed);
  reduced.node_after[0] = 0;
  // Per old node the old number of the nearest one below it that is left.
  std::vector<std::int32_t> kept_below(skeleton.node_count(), 0);
  for (std::size_t i = 1; i < skeleton.node_count(); ++i) {
    const auto node = static_cast<std::int32_t>(i);
    const std::int32_t parent = skeleton.parents()[i];
    const auto p = static_cast<std::size_t>(parent);
    kept_below[i] = reduced.node_after[p] == ReducedSkeleton::removed ? kept_below[p] : parent;
    // Leave out a node at which the branch hardly turns.
    if (children.of(node).size() == 1) {
      const bool as_it_was = reduction.order == ReductionOrder::simultaneous;
      const Vector3& here = skeleton.positions()[i];
      const Vector3 below = here - skeleton.position(as_it_was ? parent : kept_below[i]);
      const Vector3 above = skeleton.position(children.of(node).front()) - here;
      if (cosine_between(below, above) > reduction.cosine_above) continue;
    }
    // Join the others to what is left below them.
    const std::int32_t left = reduced.node_after[static_cast<std::size_t>(kept_below[i])];
    reduced.node_after[i] = reduced.skeleton.append(left, skeleton.positions()[i]);
    reduced.node_before.push_back(node);
  }
  return reduced;
}

}  // namespace phytobench
