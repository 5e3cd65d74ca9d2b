// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/component_graph/instance_tree.hpp"

namespace phytobench {

/// How many instances each link of the graph has made. The root comes from none.
std::vector<std::uint64_t> instances_per_link(const ComponentGraph& graph,
                                              const InstanceTree& tree);

/// Instances on the longest way from the root, both ends included; 0 for an empty tree.
std::uint32_t level_count(const InstanceTree& tree);

}  // namespace phytobench
