// SPDX-License-Identifier: MIT
// nanoflann's static kd-tree, KDTreeSingleIndexAdaptor, built anew in every iteration that brings
// nodes: the fastest queries of the library for the price of the rebuilding.
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include <nanoflann.hpp>

#include "core/nearest_node/nearest_perceiving.hpp"
#include "core/nearest_node/node_list.hpp"

namespace phytobench::engines {

namespace {

/// Where nanoflann reads the nodes' coordinates, side by side without the directions.
struct Coordinates {
  std::vector<std::array<double, 3>> rows;

  std::size_t kdtree_get_point_count() const { return rows.size(); }
  double kdtree_get_pt(std::size_t row, std::size_t axis) const { return rows[row][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // nanoflann finds the box itself
  }
};

/// The shape in which nanoflann wants it.
class Candidates {
 public:
  using DistanceType = double;
  using IndexType = std::size_t;

  explicit Candidates(NearestPerceiving& nearest) : nearest_(nearest) {}
  /// Returns whether the search goes on: always.
  bool addPoint(double, std::size_t row) {
    nearest_.offer(row);
    return true;
  }
  double worstDist() const { return nearest_.bound(); }
  bool full() const { return nearest_.found(); }
  std::size_t size() const { return full() ? 1 : 0; }

 private:
  NearestPerceiving& nearest_;
};

class NanoflannRebuilt : public NodeList {
 public:
  static constexpr std::size_t leaf_size = 10;  ///< nodes in a leaf at most; nanoflann's default

  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    coordinates_.rows.clear();
    tree_.buildIndex();  // of no nodes: finds nothing
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    if (nodes.empty()) return 0;
    NodeList::insert(nodes);
    for (const SearchableNode& node : nodes)
      coordinates_.rows.push_back({node.position.x, node.position.y, node.position.z});
    tree_.buildIndex();
    return nodes_.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestPerceiving found(nodes_, point, perception, work);
    Candidates candidates(found);
    const double query[] = {point.x, point.y, point.z};
    tree_.findNeighbors(candidates, query, nanoflann::SearchParams());
    return found.best();
  }

 private:
  using Distance = nanoflann::L2_Simple_Adaptor<double, Coordinates>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Coordinates, 3>;

  Coordinates coordinates_;  ///< before the tree, which refers to it from its construction on
  Tree tree_{3, coordinates_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)};
};

}  // namespace

extern const EngineDescriptor nanoflann_rebuilt;
constinit const EngineDescriptor nanoflann_rebuilt{
    .name = "nanoflann_rebuilt",
    .summary = "Asks nanoflann's static kd-tree, rebuilt in every iteration that brings nodes.",
    .source = "nanoflann (Blanco-Claraco), KDTreeSingleIndexAdaptor",
    .library = "nanoflann 1.4",
    .create = make_point_driven_engine<NanoflannRebuilt, KillBy::grid>,
};

}  // namespace phytobench::engines
