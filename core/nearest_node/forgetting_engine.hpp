// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Lets any engine forget nodes, which the contract of engines knows nothing of: after some have
/// been forgotten, the engine starts afresh with the points that live and the nodes that are left,
/// in their old order. So ties go as before, no engine has to change, and its counters show
/// what it then really computes. Costs a reset whenever something was forgotten, and one pass over
/// the points per association: engines that look at every node gain, one that remembers each
/// point's nearest node loses.
class ForgettingEngine final : public NearestNodeEngine {
 public:
  /// The engine may come to hold points that live here: once this object is gone, nothing may be
  /// asked of the engine before its next reset().
  explicit ForgettingEngine(NearestNodeEngine& engine) : engine_(engine) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override;
  /// Nodes that were forgotten keep their numbers, and perceive nothing.
  Assignment associate(std::span<const SearchableNode> new_nodes) override;
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double kill_distance) override;
  std::size_t live_points() const override { return live_points_; }
  WorkCounters counters() const override;

  /// From the next association on these nodes are nobody's nearest. Each must have been handed to
  /// associate(), and may be forgotten once.
  void forget(std::span<const NodeIndex> nodes);

 private:
  void start_afresh();
  void translate(const Assignment& assignment);

  NearestNodeEngine& engine_;
  EngineSetup setup_;
  std::span<const Vector3> points_;
  std::vector<std::uint8_t> is_removed_;  // per point
  std::size_t live_points_ = 0;
  std::vector<SearchableNode> nodes_;       // all of them
  std::vector<std::uint8_t> is_forgotten_;  // per node
  bool is_outdated_ = false;                // the engine knows nodes that are forgotten
  // What the engine has, and under which numbers it is known outside.
  std::vector<Vector3> its_points_;
  std::vector<PointIndex> point_of_its_;
  std::vector<NodeIndex> node_of_its_;
  WorkCounters work_before_;  // of its lives before this one
  std::vector<NodeIndex> node_of_point_;
  PointSet associated_;
  std::vector<PointIndex> its_associated_, removed_;
};

}  // namespace phytobench
