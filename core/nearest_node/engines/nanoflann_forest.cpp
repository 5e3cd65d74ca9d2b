// SPDX-License-Identifier: MIT
// nanoflann's growing kd-tree, KDTreeSingleIndexDynamicAdaptor: a forest of static trees of 1, 2,
// 4, ... nodes that are merged like the digits of a binary counter (Bentley and Saxe's logarithmic
// method). New nodes cost little; in return every query visits every tree.
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// GCC 12 warns, wherever the empty trees are copied, of bounding boxes that nobody has filled yet.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <nanoflann.hpp>
#pragma GCC diagnostic pop

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

class NanoflannForest : public NodeList {
 public:
  static constexpr std::size_t leaf_size = 10;  ///< nodes in a leaf at most; nanoflann's default

  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    forest_.reset();
    coordinates_.rows.clear();
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    if (nodes.empty()) return 0;
    // Made while there are no coordinates: the constructor would add those that it finds.
    if (!forest_)
      forest_.emplace(3, coordinates_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size),
                      most_nodes);
    const std::size_t before = nodes_.size();
    NodeList::insert(nodes);
    for (const SearchableNode& node : nodes)
      coordinates_.rows.push_back({node.position.x, node.position.y, node.position.z});
    forest_->addPoints(static_cast<std::uint32_t>(before),
                       static_cast<std::uint32_t>(nodes_.size() - 1));  // the last is included
    return rebuilt_nodes(before, nodes_.size());
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestPerceiving found(nodes_, point, perception, work);
    Candidates candidates(found);
    const double query[] = {point.x, point.y, point.z};
    if (forest_) forest_->findNeighbors(candidates, query, nanoflann::SearchParams());
    return found.best();
  }

 private:
  using Distance = nanoflann::L2_Simple_Adaptor<double, Coordinates>;
  using Forest = nanoflann::KDTreeSingleIndexDynamicAdaptor<Distance, Coordinates, 3>;

  static constexpr std::size_t most_nodes = std::numeric_limits<NodeIndex>::max();

  /// Tree k holds 2^k nodes if digit k of their number is 1, else none. One call of addPoints()
  /// builds, once, the trees up to the highest digit that changes.
  static std::uint64_t rebuilt_nodes(std::uint64_t before, std::uint64_t after) {
    return after & ((std::uint64_t{1} << std::bit_width(before ^ after)) - 1);
  }

  Coordinates coordinates_;  ///< outlives the forest, which refers to it
  std::optional<Forest> forest_;
};

}  // namespace

extern const EngineDescriptor nanoflann_forest;
constinit const EngineDescriptor nanoflann_forest{
    .name = "nanoflann_forest",
    .summary = "Asks nanoflann's forest of kd-trees, to which each iteration adds its nodes.",
    .source = "nanoflann (Blanco-Claraco), KDTreeSingleIndexDynamicAdaptor",
    .library = "nanoflann 1.4",
    .create = make_point_driven_engine<NanoflannForest, KillBy::grid>,
};

}  // namespace phytobench::engines
