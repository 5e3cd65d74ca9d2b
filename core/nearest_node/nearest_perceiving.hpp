// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>

#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench {

/// Takes the candidates that a library's k-d tree offers for one point, in any order, and keeps the
/// nearest that perceives it. Decides by our squared distance, and lets the library prune with a
/// little more than that.
class NearestPerceiving {
 public:
  NearestPerceiving(std::span<const SearchableNode> nodes, const Vector3& point,
                    const Perception& perception, WorkCounters& work)
      : nodes_(nodes),
        point_(point),
        perception_(perception),
        work_(work),
        best_{no_node, perception.beyond_reach()} {}

  void offer(std::size_t row) {
    const SearchableNode& node = nodes_[row];
    const auto index = static_cast<NodeIndex>(row);
    const double squared = squared_distance(point_, node.position);
    ++work_.search_evaluations;
    if (!best_.beaten_by(squared, index)) return;
    if constexpr (counts_inner_loop) ++work_.angle_tests;
    if (!perception_.within_angle(node.position, node.direction, point_, squared)) return;
    best_ = {index, squared};
  }

  /// One part in 10^12 more, because libraries add their lower bounds up in another order than
  /// squared_distance(). Never 0, because they offer only what is strictly nearer: of two nodes at
  /// the very point the lower index would be lost.
  double bound() const {
    return best_.squared_distance * (1.0 + 1e-12) + std::numeric_limits<double>::min();
  }

  bool found() const { return best_.node != no_node; }
  const NearestHit& best() const { return best_; }

 private:
  std::span<const SearchableNode> nodes_;
  const Vector3& point_;
  const Perception& perception_;
  WorkCounters& work_;
  NearestHit best_;
};

}  // namespace phytobench
