// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench::experiments::brzoska2019 {

/// An engine that lets an experiment look at every answer before the tree grows on it. `nodes` are
/// all searchable nodes so far; `seen` is called after each association, `removed` after each
/// removal.
class ObservedEngine final : public NearestNodeEngine {
 public:
  explicit ObservedEngine(const EngineDescriptor& engine) : inner_(engine.create()) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    nodes.clear();
    alive.assign(points.size(), true);
    inner_->reset(points, setup);
  }

  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    nodes.insert(nodes.end(), new_nodes.begin(), new_nodes.end());
    const Assignment assignment = inner_->associate(new_nodes);
    if (associated) associated(assignment);
    return assignment;
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const auto removed = inner_->kill(killers, distance);
    for (const PointIndex point : removed) alive[static_cast<std::size_t>(point)] = false;
    if (killed) killed(killers, distance);
    return removed;
  }

  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }

  std::function<void(const Assignment&)> associated = {};
  std::function<void(std::span<const SearchableNode>, double)> killed = {};
  std::vector<SearchableNode> nodes;
  std::vector<bool> alive;  ///< per point

 private:
  std::unique_ptr<NearestNodeEngine> inner_;
};

}  // namespace phytobench::experiments::brzoska2019
