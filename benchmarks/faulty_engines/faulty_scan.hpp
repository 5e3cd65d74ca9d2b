// SPDX-License-Identifier: MIT
#pragma once

#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench {

/// A plain scan with one mistake. The mistake says how many nodes are looked at, which candidate
/// wins, and what becomes of the answer; what it leaves alone is right.
template <class Mistake>
class FaultyScan : public NodeList {
 public:
  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    for (std::size_t i = 0; i < Mistake::nodes_looked_at(nodes_.size()); ++i) {
      const SearchableNode& node = nodes_[i];
      const double squared = Mistake::measured(squared_distance(point, node.position));
      if (squared > perception.squared_reach() || !Mistake::wins(squared, best.squared_distance))
        continue;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {static_cast<NodeIndex>(i), squared};
    }
    work.search_evaluations += nodes_.size();
    return best;
  }
};

/// No mistake at all; each faulty engine replaces one of these.
struct NoMistake {
  static std::size_t nodes_looked_at(std::size_t count) { return count; }
  static bool wins(double candidate, double best) { return candidate < best; }
  static double measured(double squared_distance) { return squared_distance; }
};

}  // namespace phytobench
