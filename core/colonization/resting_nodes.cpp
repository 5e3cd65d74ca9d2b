// SPDX-License-Identifier: MIT
#include "core/colonization/resting_nodes.hpp"

#include "core/contract/check.hpp"

namespace phytobench {

RestingNodes::RestingNodes(std::int32_t rest_iterations, std::size_t start_nodes)
    : rest_iterations_(rest_iterations), begins_{0} {
  PHYTOBENCH_EXPECT(rest_iterations >= 1);
  last_event_.resize(start_nodes);
  for (std::size_t i = 0; i < start_nodes; ++i) note(static_cast<NodeIndex>(i));
}

void RestingNodes::note(NodeIndex node) {
  last_event_[static_cast<std::size_t>(node)] = iteration_;
  events_.push_back(node);
}

std::span<const NodeIndex> RestingNodes::after_iteration(std::span<const NodeIndex> parents,
                                                         std::size_t new_nodes) {
  ++iteration_;
  begins_.push_back(events_.size());
  for (const NodeIndex parent : parents) note(parent);
  const std::size_t before = last_event_.size();
  last_event_.resize(before + new_nodes);
  for (std::size_t i = before; i < last_event_.size(); ++i) note(static_cast<NodeIndex>(i));

  resting_.clear();
  const std::int32_t tired_since = iteration_ - rest_iterations_;
  if (tired_since < 0) return resting_;
  const auto then = static_cast<std::size_t>(tired_since);
  for (std::size_t i = begins_[then]; i < begins_[then + 1]; ++i)
    if (last_event_[static_cast<std::size_t>(events_[i])] == tired_since)
      resting_.push_back(events_[i]);
  count_ += resting_.size();
  return resting_;
}

}  // namespace phytobench
