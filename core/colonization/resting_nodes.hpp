// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Finds the nodes that have got no child in a number of iterations in a row ([Liebemann2017] sec.
/// 3.5, max_NG). A node counts from the iteration after the one that made it, and afresh from each
/// child. Work is in proportion to the nodes that grow, not to those that exist.
class RestingNodes {
 public:
  /// rest_iterations >= 1; so many nodes exist before the first iteration.
  RestingNodes(std::int32_t rest_iterations, std::size_t start_nodes);

  /// To be called after each iteration with the nodes that got a child in it, each once; so many
  /// new nodes have come at the end of the list. Returns the nodes that rest from now on; valid
  /// until the next call.
  std::span<const NodeIndex> after_iteration(std::span<const NodeIndex> parents,
                                             std::size_t new_nodes);

  /// All that rest by now.
  std::size_t count() const { return count_; }

 private:
  void note(NodeIndex node);

  std::int32_t rest_iterations_;
  std::int32_t iteration_ = 0;  // of the events being noted; 0 is before the first one
  std::size_t count_ = 0;
  std::vector<std::int32_t> last_event_;  // per node: the iteration that made it or its last child
  std::vector<NodeIndex> events_;         // nodes by iteration
  std::vector<std::size_t> begins_;       // per iteration its place among the events
  std::vector<NodeIndex> resting_;
};

}  // namespace phytobench
