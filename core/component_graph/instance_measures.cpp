// SPDX-License-Identifier: MIT
#include "core/component_graph/instance_measures.hpp"

#include <algorithm>

#include "core/component_graph/instance_identity.hpp"

namespace phytobench {

std::vector<std::uint64_t> instances_per_link(const ComponentGraph& graph,
                                              const InstanceTree& tree) {
  std::vector<std::uint64_t> counts(graph.links.size(), 0);
  for (const Instance& instance : tree.instances)
    if (instance.link != any_link) ++counts[instance.link];
  return counts;
}

std::uint32_t level_count(const InstanceTree& tree) {
  std::vector<std::uint32_t> levels;  // of each instance; parents stand first
  levels.reserve(tree.instances.size());
  std::uint32_t most = 0;
  for (const Instance& instance : tree.instances) {
    levels.push_back(instance.link == any_link ? 1 : levels[instance.parent] + 1);
    most = std::max(most, levels.back());
  }
  return most;
}

}  // namespace phytobench
