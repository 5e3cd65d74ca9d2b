// SPDX-License-Identifier: MIT
// Wrong on purpose: right nodes, distances rounded to float.
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
      if (!(squared < best.squared_distance)) continue;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {static_cast<NodeIndex>(i), squared};
    }
    best.squared_distance = static_cast<double>(static_cast<float>(best.squared_distance));
    work.search_evaluations += nodes_.size();
    return best;
  }

 private:
  std::vector<SearchableNode> nodes_;
};

}  // namespace

extern const EngineDescriptor rounds_distances;
constinit const EngineDescriptor rounds_distances{
    .name = "rounds_distances",
    .summary = "Wrong on purpose: right nodes, distances rounded to float.",
    .source = "single precision",
    .create = make_point_driven_engine<Faulty>,
};

}  // namespace phytobench::engines
