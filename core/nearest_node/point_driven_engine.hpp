// SPDX-License-Identifier: MIT
// The one driver of all engines that ask, point by point, "which node is nearest?". It keeps the
// live points and the box of option N, and removes points. An engine adds only its
// node index.
#pragma once

#include <atomic>
#include <concepts>
#include <vector>

#include "core/contract/check.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/engine.hpp"
#include "core/nearest_node/kill_grid.hpp"
#include "core/nearest_node/kill_scan.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

/// The nearest perceiving node of one point.
struct NearestHit {
  NodeIndex node = no_node;
  double squared_distance = 0.0;

  /// Whether a candidate beats this hit: nearer, or equally near with a lower index.
  bool beaten_by(double candidate_squared_distance, NodeIndex candidate) const {
    return candidate_squared_distance < squared_distance ||
           (candidate_squared_distance == squared_distance && node != no_node && candidate < node);
  }
};

/// What a point-driven engine supplies. nearest() must be callable from several threads at once and
/// adds its work to the counters it is given.
template <class Index>
concept NodeSearchIndex = std::default_initializable<Index> &&
    requires(Index index, const Index constant, std::span<const Vector3> points,
             std::span<const SearchableNode> nodes, const Perception& perception, PointIndex point,
             WorkCounters& work) {
  index.reset(points, 1.0);
  { index.insert(nodes) } -> std::convertible_to<std::uint64_t>;
  { constant.nearest(point, points[0], perception, work) } -> std::same_as<NearestHit>;
};

/// How points near new nodes are found.
enum class KillBy {
  scan,  ///< every live point against every killer, without early exit, as the thesis' rows have it
  grid,  ///< killers in a grid
};

template <NodeSearchIndex Index, KillBy kill_by>
class PointDrivenEngine final : public NearestNodeEngine {
 public:
  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    PHYTOBENCH_EXPECT(setup.influence_distance >= smallest_influence_distance);
    points_ = points;
    setup_ = setup;
    perception_ = Perception(setup.influence_distance, setup.perception_half_angle_rad);
    box_ = {};
    work_ = {};
    node_of_point_.assign(points.size(), no_node);
    associated_.reset(points.size());
    live_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) live_[i] = static_cast<PointIndex>(i);
    index_.reset(points, setup.influence_distance);
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    work_.index_updates += index_.insert(new_nodes);
    extend_box(new_nodes);
    for_live_points(setup_.search_filter,
                    [this](PointIndex point, bool inside, WorkCounters& work) {
                      const auto i = static_cast<std::size_t>(point);
                      NearestHit hit{no_node, perception_.beyond_reach()};
                      if (inside) {
                        ++work.queries;
                        hit = index_.nearest(point, points_[i], perception_, work);
                      }
                      node_of_point_[i] = hit.node;
                    });
    note_associated();
    return {node_of_point_, associated_};
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override {
    extend_box(killers);
    doomed_.assign(points_.size(), 0);
    const double squared_reach = kill_distance * kill_distance;
    if constexpr (kill_by == KillBy::grid) grid_.build(killers, kill_distance);
    for_live_points(setup_.kill_filter, [&](PointIndex point, bool inside, WorkCounters& work) {
      if (!inside) return;
      const auto i = static_cast<std::size_t>(point);
      if constexpr (kill_by == KillBy::grid) {
        doomed_[i] = grid_.reaches(points_[i], work.kill_evaluations);
      } else {
        work.kill_evaluations += killers.size();
        doomed_[i] = is_reached_by_any(points_[i], killers, squared_reach);
      }
    });
    return remove_doomed();
  }

  std::size_t live_points() const override { return live_.size(); }
  WorkCounters counters() const override { return work_; }

 private:
  void extend_box(std::span<const SearchableNode> nodes) {
    for (const SearchableNode& node : nodes) box_.extend(node.position);
  }

  /// Calls visit(point, passes the filter, counters) for each live point, in blocks on several
  /// threads.
  template <class Visit>
  void for_live_points(PointFilter filter, const Visit& visit) {
    const bool filtered = filter == PointFilter::bounding_box;
    const BoundingBox reach = box_.widened(setup_.influence_distance);
    std::atomic<std::uint64_t> search{0}, kills{0}, cells{0}, queries{0}, angles{0};
    for_blocks(live_.size(), setup_.threads, [&](std::size_t begin, std::size_t end) {
      WorkCounters work;
      for (std::size_t i = begin; i < end; ++i) {
        const PointIndex point = live_[i];
        visit(point, !filtered || reach.contains(points_[static_cast<std::size_t>(point)]), work);
      }
      search += work.search_evaluations;
      kills += work.kill_evaluations;
      cells += work.cells_visited;
      queries += work.queries;
      angles += work.angle_tests;
    });
    work_ += {search, kills, cells, 0, queries, angles};
  }

  /// Neighbouring points share a word of the set, so one thread fills it.
  void note_associated() {
    associated_.clear();
    for (const PointIndex point : live_)
      if (node_of_point_[static_cast<std::size_t>(point)] != no_node) associated_.insert(point);
  }

  /// Takes the marked points out of the live list, which stays ascending.
  std::span<const PointIndex> remove_doomed() {
    removed_.clear();
    std::size_t kept = 0;
    for (const PointIndex point : live_) {
      const auto i = static_cast<std::size_t>(point);
      if (doomed_[i]) {
        node_of_point_[i] = no_node;
        associated_.erase(point);
        removed_.push_back(point);
      } else {
        live_[kept++] = point;
      }
    }
    live_.resize(kept);
    return removed_;
  }

  std::span<const Vector3> points_;
  EngineSetup setup_;
  Perception perception_{1.0, 1.0};
  BoundingBox box_;
  Index index_;
  KillGrid grid_;
  std::vector<PointIndex> live_;
  std::vector<NodeIndex> node_of_point_;
  PointSet associated_;
  std::vector<std::uint8_t> doomed_;
  std::vector<PointIndex> removed_;
  WorkCounters work_;
};

/// Factory for a descriptor.
template <NodeSearchIndex Index, KillBy kill_by = KillBy::scan>
std::unique_ptr<NearestNodeEngine> make_point_driven_engine() {
  return std::make_unique<PointDrivenEngine<Index, kill_by>>();
}

}  // namespace phytobench
