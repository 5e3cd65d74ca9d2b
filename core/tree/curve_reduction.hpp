// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Whose edges decide whether a node is removed; the text leaves it open.
enum class ReductionOrder {
  simultaneous,  ///< those of the tree as it was: every node of a gentle curve goes
  root_to_tip,   ///< those that are left: a removed node has joined the two edges at it
};

struct CurveReduction {
  /// Nodes go where the cosine between the edges below and above is greater than this; [-1, 1], and
  /// 1 removes nothing.
  double cosine_above = 1.0;
  ReductionOrder order = ReductionOrder::simultaneous;
};

/// A tree with fewer nodes, and who is who.
struct ReducedSkeleton {
  static constexpr std::int32_t removed = -1;

  Skeleton skeleton{Vector3{}};
  std::vector<std::int32_t> node_before;  ///< per node that is left its old number, ascending
  std::vector<std::int32_t> node_after;   ///< per old node its new number, or `removed`
};

/// Removes nodes with one parent and one child where the branch hardly turns ([Liebemann2017] sec.
/// 3.5, eq. 3.6); the child becomes the parent's. Root, tips and forks stay, and their order. An
/// edge without length has no direction: nodes at its ends stay.
ReducedSkeleton reduce_curves(const Skeleton& skeleton, const CurveReduction& reduction);

}  // namespace phytobench
