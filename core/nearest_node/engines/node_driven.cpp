// SPDX-License-Identifier: MIT
// Nodes are only added and never move, so a point's nearest node changes only because of a new one.
// Every point remembers its smallest squared distance; a new node visits the live points in its
// reach through an index over the points, which never changes but for points that leave it.
#include <algorithm>
#include <memory>
#include <vector>

#include "core/contract/check.hpp"
#include "core/memory/large_array.hpp"
#include "core/nearest_node/engine.hpp"
#include "core/nearest_node/node_driven/row_search.hpp"
#include "core/nearest_node/node_driven/tree_search.hpp"

namespace phytobench::engines {

namespace {

class NodeDriven final : public NearestNodeEngine {
 public:
  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    PHYTOBENCH_EXPECT(setup.influence_distance >= smallest_influence_distance);
    search_ = &tree_;
    if (rows_.reset(points, setup))
      search_ = &rows_;
    else
      tree_.reset(points, setup);
    node_of_point_.resize_for_overwrite(points.size());
    std::fill(node_of_point_.begin(), node_of_point_.end(), no_node);
    associated_.reset(points.size());
    live_points_ = points.size();
    nodes_ = 0;
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    reached_.clear();
    search_->associate(new_nodes, nodes_, {node_of_point_.data(), node_of_point_.size()}, reached_);
    nodes_ += static_cast<NodeIndex>(new_nodes.size());
    for (const PointIndex point : reached_) associated_.insert(point);
    return {{node_of_point_.data(), node_of_point_.size()}, associated_};
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override {
    removed_.clear();
    search_->remove(killers, kill_distance * kill_distance, removed_);
    for (std::size_t i = 0; i < removed_.size(); ++i) {
      prefetch_node_of(removed_[std::min(i + steps_ahead, removed_.size() - 1)]);
      NodeIndex& node = node_of_point_[static_cast<std::size_t>(removed_[i])];
      if (node == no_node) continue;
      node = no_node;
      associated_.erase(removed_[i]);
    }
    live_points_ -= removed_.size();
    return removed_;
  }

  std::size_t live_points() const override { return live_points_; }
  WorkCounters counters() const override {
    WorkCounters work = search_->counters();
    work.index_updates = static_cast<std::uint64_t>(nodes_);
    return work;
  }

 private:
  /// Points lie anywhere in memory: asked for so many steps before they are needed.
  static constexpr std::size_t steps_ahead = 16;
  void prefetch_node_of(PointIndex point) const {
    __builtin_prefetch(&node_of_point_[static_cast<std::size_t>(point)], 1);
  }

  RowSearch rows_;
  TreeSearch tree_;
  PointSearch* search_ = &rows_;  ///< the one that suits the points
  LargeArray<NodeIndex> node_of_point_;
  PointSet associated_;
  std::vector<PointIndex> reached_;
  std::vector<PointIndex> removed_;
  std::size_t live_points_ = 0;
  NodeIndex nodes_ = 0;
};

std::unique_ptr<NearestNodeEngine> create() {
  return std::make_unique<NodeDriven>();
}

}  // namespace

extern const EngineDescriptor node_driven;
constinit const EngineDescriptor node_driven{
    .name = "node_driven",
    .summary =
        "Every point keeps its nearest node; a new node visits only the live points in its reach.",
    .source = "phytobench; that time coherence helps is said in Runions et al. 2005",
    .uses_point_filter = false,
    .create = create,
};

}  // namespace phytobench::engines
