// SPDX-License-Identifier: MIT
// Curve reduction in the two orders that [Liebemann2017] eq. 3.6 allows.
#pragma once

#include <cstdint>
#include <utility>

#include "core/tree/curve_reduction.hpp"
#include "reference/oracles/liebemann2017_curve_reduction.hpp"

namespace phytobench::experiments::liebemann2017 {

/// With the names that measurements have.
inline constexpr std::pair<ReductionOrder, const char*> orders[] = {
    {ReductionOrder::simultaneous, "at_once"}, {ReductionOrder::root_to_tip, "root_to_tip"}};

inline oracles::liebemann2017::ReductionOrder literal_order(ReductionOrder order) {
  return order == ReductionOrder::simultaneous
             ? oracles::liebemann2017::ReductionOrder::simultaneous
             : oracles::liebemann2017::ReductionOrder::root_to_tip;
}

inline ReducedSkeleton reduced(const Skeleton& skeleton, double cosine, ReductionOrder order) {
  CurveReduction reduction;
  reduction.cosine_above = cosine;
  reduction.order = order;
  return reduce_curves(skeleton, reduction);
}

inline std::int64_t nodes_left(const Skeleton& skeleton, double cosine, ReductionOrder order) {
  return static_cast<std::int64_t>(reduced(skeleton, cosine, order).skeleton.node_count());
}

}  // namespace phytobench::experiments::liebemann2017
