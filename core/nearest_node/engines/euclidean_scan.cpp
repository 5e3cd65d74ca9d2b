// SPDX-License-Identifier: MIT
// The literal loop of [Brzoska2019] sec. 5.2.2 with eq. 23: every node, one square root per pair.
#include <cmath>

#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

class EuclideanScan : public NodeList {
 public:
  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    double best_distance = std::sqrt(best.squared_distance);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const SearchableNode& node = nodes_[i];
      const double squared = squared_distance(point, node.position);
      const double distance = std::sqrt(squared);
      if (distance > best_distance) continue;
      // Two different squares may share one rounded root: the squares decide, as in every other
      // engine.
      if (!(squared < best.squared_distance)) continue;
      if constexpr (counts_inner_loop) ++work.angle_tests;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {static_cast<NodeIndex>(i), squared};
      best_distance = distance;
    }
    work.search_evaluations += nodes_.size();
    return best;
  }
};

}  // namespace

extern const EngineDescriptor euclidean_scan;
constinit const EngineDescriptor euclidean_scan{
    .name = "euclidean_scan",
    .summary =
        "Compares every live point with every node by the Euclidean distance, one root per pair.",
    .source = "[Brzoska2019] sec. 5.2.2, eq. 23",
    .create = make_point_driven_engine<EuclideanScan>,
};

}  // namespace phytobench::engines
