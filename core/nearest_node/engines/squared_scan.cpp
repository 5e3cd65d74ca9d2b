// SPDX-License-Identifier: MIT
// The literal loop of [Brzoska2019] sec. 5.2.2 with eq. 24: every node, no square root.
#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

class SquaredScan : public NodeList {
 public:
  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const SearchableNode& node = nodes_[i];
      const double squared = squared_distance(point, node.position);
      if (!(squared < best.squared_distance)) continue;
      if constexpr (counts_inner_loop) ++work.angle_tests;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {static_cast<NodeIndex>(i), squared};
    }
    work.search_evaluations += nodes_.size();
    return best;
  }
};

}  // namespace

extern const EngineDescriptor squared_scan;
constinit const EngineDescriptor squared_scan{
    .name = "squared_scan",
    .summary = "Compares every live point with every node by the squared distance.",
    .source = "[Brzoska2019] sec. 5.2.2, eq. 24",
    .create = make_point_driven_engine<SquaredScan>,
};

}  // namespace phytobench::engines
