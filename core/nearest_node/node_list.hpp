// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// The index of engines that keep no order: all nodes, in the order of their indices.
class NodeList {
 public:
  void reset(std::span<const Vector3>, double) { nodes_.clear(); }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
    return nodes.size();
  }

 protected:
  std::vector<SearchableNode> nodes_;
};

}  // namespace phytobench
