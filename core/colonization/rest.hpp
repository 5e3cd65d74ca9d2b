// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/colonization/resting_nodes.hpp"
#include "core/nearest_node/forgetting_engine.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// What growth needs if nodes can come to rest ([Liebemann2017] sec. 3.5, max_NG): it asks engine()
/// instead of the engine given here, and says after each iteration what grew.
class Rest {
 public:
  Rest(std::int32_t rest_iterations, std::size_t start_nodes, NearestNodeEngine& engine)
      : nodes_(rest_iterations, start_nodes), engine_(engine) {}

  NearestNodeEngine& engine() { return engine_; }
  std::size_t resting() const { return nodes_.count(); }

  /// `tree` has got so many nodes in this iteration; its node `first` is searchable node 0.
  void note(const Skeleton& tree, std::int32_t first, std::size_t new_nodes) {
    parents_.clear();
    for (std::size_t i = tree.node_count() - new_nodes; i < tree.node_count(); ++i)
      parents_.push_back(tree.parents()[i] - first);
    engine_.forget(nodes_.after_iteration(parents_, new_nodes));
  }

 private:
  RestingNodes nodes_;
  ForgettingEngine engine_;
  std::vector<NodeIndex> parents_;  // that grew in this iteration
};

}  // namespace phytobench
