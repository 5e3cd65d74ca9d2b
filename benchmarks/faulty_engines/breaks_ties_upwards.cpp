// SPDX-License-Identifier: MIT
// Wrong on purpose: of equally near nodes it takes the highest index.
#include <vector>

#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

class Faulty {
 public:
  void reset(std::span<const Vector3>, double) { nodes_.clear(); }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    return nodes.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const SearchableNode& node = nodes_[i];
      const double squared = squared_distance(point, node.position);
      if (!(squared <= best.squared_distance) || squared > perception.squared_reach()) continue;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {static_cast<NodeIndex>(i), squared};
    }
    work.search_evaluations += nodes_.size();
    return best;
  }

 private:
  std::vector<SearchableNode> nodes_;
};

}  // namespace

extern const EngineDescriptor breaks_ties_upwards;
constinit const EngineDescriptor breaks_ties_upwards{
    .name = "breaks_ties_upwards",
    .summary = "Wrong on purpose: of equally near nodes it takes the highest index.",
    .source = "a <= where a < belongs",
    .create = make_point_driven_engine<Faulty>,
};

}  // namespace phytobench::engines
