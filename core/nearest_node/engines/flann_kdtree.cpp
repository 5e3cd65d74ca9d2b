// SPDX-License-Identifier: MIT
// FLANN's exact kd-tree, KDTreeSingleIndex (its randomised trees only come close to the nearest).
// It cannot grow: its addPoints() ignores the rebuild threshold and builds everything anew, and
// that is what every iteration with new nodes does here.
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <flann/config.h>
#include <flann/flann.hpp>

#include "core/nearest_node/nearest_perceiving.hpp"
#include "core/nearest_node/node_list.hpp"

namespace phytobench::engines {

namespace {

/// The shape in which FLANN wants it.
class Candidates final : public flann::ResultSet<double> {
 public:
  explicit Candidates(NearestPerceiving& nearest) : nearest_(nearest) {}
  void addPoint(double, std::size_t row) override { nearest_.offer(row); }
  double worstDist() const override { return nearest_.bound(); }
  bool full() const override { return nearest_.found(); }

 private:
  NearestPerceiving& nearest_;
};

class FlannKdTree : public NodeList {
 public:
  static constexpr int leaf_size = 10;  ///< nodes in a leaf at most; FLANN's default

  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    tree_.reset();
    coordinates_.clear();
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    if (nodes.empty()) return 0;
    NodeList::insert(nodes);
    tree_.reset();  // it points into the coordinates, which may now move
    for (const SearchableNode& node : nodes)
      coordinates_.insert(coordinates_.end(), {node.position.x, node.position.y, node.position.z});
    tree_.emplace(flann::Matrix<double>(coordinates_.data(), nodes_.size(), 3),
                  flann::KDTreeSingleIndexParams(leaf_size));
    tree_->buildIndex();
    return nodes_.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestPerceiving found(nodes_, point, perception, work);
    Candidates candidates(found);
    const double query[] = {point.x, point.y, point.z};
    if (tree_) tree_->findNeighbors(candidates, query, flann::SearchParams());
    return found.best();
  }

 private:
  std::vector<double> coordinates_;  ///< x, y, z of each node, row by row
  std::optional<flann::KDTreeSingleIndex<flann::L2_Simple<double>>> tree_;
};

}  // namespace

extern const EngineDescriptor flann_kdtree;
constinit const EngineDescriptor flann_kdtree{
    .name = "flann_kdtree",
    .summary = "Asks FLANN's exact kd-tree, rebuilt in every iteration that brings nodes.",
    .source = "FLANN (Muja and Lowe), KDTreeSingleIndex",
    .library = "FLANN " FLANN_VERSION_,
    .create = make_point_driven_engine<FlannKdTree, KillBy::grid>,
};

}  // namespace phytobench::engines
