// SPDX-License-Identifier: MIT
// FLANN's exact kd-tree, KDTreeSingleIndex (its randomised trees only come close to the nearest).
// It cannot grow: its addPoints() ignores the rebuild threshold and builds everything anew, and
// that is what every iteration with new nodes does here.
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <flann/flann.hpp>

#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

/// What FLANN offers candidates to. It decides by our squared distance and lets FLANN prune with a
/// little more than that.
class NearestPerceiving final : public flann::ResultSet<double> {
 public:
  NearestPerceiving(std::span<const SearchableNode> nodes, const Vector3& point,
                    const Perception& perception, WorkCounters& work)
      : nodes_(nodes),
        point_(point),
        perception_(perception),
        work_(work),
        best_{no_node, perception.beyond_reach()} {}

  void addPoint(double, std::size_t row) override {
    const SearchableNode& node = nodes_[row];
    const auto index = static_cast<NodeIndex>(row);
    const double squared = squared_distance(point_, node.position);
    ++work_.search_evaluations;
    if (!best_.beaten_by(squared, index)) return;
    if constexpr (counts_inner_loop) ++work_.angle_tests;
    if (!perception_.within_angle(node.position, node.direction, point_, squared)) return;
    best_ = {index, squared};
  }

  /// One part in 10^12 more, because FLANN adds its lower bounds up in another order than
  /// squared_distance(). Never 0, because FLANN offers only what is strictly nearer: of two nodes
  /// at the very point the lower index would be lost.
  double worstDist() const override {
    return best_.squared_distance * (1.0 + 1e-12) + std::numeric_limits<double>::min();
  }

  bool full() const override { return best_.node != no_node; }
  const NearestHit& best() const { return best_; }

 private:
  std::span<const SearchableNode> nodes_;
  const Vector3& point_;
  const Perception& perception_;
  WorkCounters& work_;
  NearestHit best_;
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
    const double query[] = {point.x, point.y, point.z};
    if (tree_) tree_->findNeighbors(found, query, flann::SearchParams());
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
    .create = make_point_driven_engine<FlannKdTree, KillBy::grid>,
};

}  // namespace phytobench::engines
