// SPDX-License-Identifier: MIT
#include "core/component_graph/instance_tree.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/component_graph/graph_unfolding.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Instances of a subtree, at most `limit`.
class InstanceCounter {
 public:
  InstanceCounter(const ComponentGraph& graph, const InstanceLimits& limits)
      : graph_(graph), unfolding_(graph, limits), limit_(limits.most_instances + 1) {}

  std::uint64_t run() { return unfolding_.may_follow(graph_.root) ? below(unfolding_.root()) : 0; }

 private:
  std::uint64_t below(const Instance& instance) {
    const GraphUnfolding::Visit visit(unfolding_, instance.prototype);
    std::uint64_t count = 1;
    unfolding_.for_each_link(instance, [&](std::uint32_t link, std::uint64_t n) {
      count = sum(count, along(instance, link, n));
      return count < limit_;
    });
    return count;
  }

  /// Of all n that one link makes.
  std::uint64_t along(const Instance& instance, std::uint32_t position, std::uint64_t n) {
    if (n >= limit_) return limit_;
    const auto last = static_cast<std::uint32_t>(n);
    if (unfolding_.siblings_are_alike(graph_.links[position].to)) {
      const std::uint64_t one = below(unfolding_.child(instance, 0, position, {1, last}));
      return one > limit_ / n ? limit_ : std::min(limit_, one * n);
    }
    std::uint64_t count = 0;
    for (std::uint32_t i = 1; i <= last && count < limit_; ++i)
      count = sum(count, below(unfolding_.child(instance, 0, position, {i, last})));
    return count;
  }

  std::uint64_t sum(std::uint64_t a, std::uint64_t b) const { return std::min(limit_, a + b); }

  const ComponentGraph& graph_;
  GraphUnfolding unfolding_;
  std::uint64_t limit_;
};

class InstanceMaker {
 public:
  InstanceMaker(const ComponentGraph& graph, const InstanceLimits& limits)
      : graph_(graph), unfolding_(graph, limits) {}

  InstanceTree run(std::uint64_t count) {
    tree_.instances.reserve(count);
    if (unfolding_.may_follow(graph_.root)) make(unfolding_.root());
    PHYTOBENCH_ENSURE(tree_.instances.size() == count);
    return std::move(tree_);
  }

 private:
  void make(const Instance& instance) {
    const GraphUnfolding::Visit visit(unfolding_, instance.prototype);
    const auto position = static_cast<std::uint32_t>(tree_.instances.size());
    tree_.instances.push_back(instance);
    unfolding_.for_each_link(instance, [&](std::uint32_t link, std::uint64_t n) {
      const auto last = static_cast<std::uint32_t>(n);  // no more than all instances
      for (std::uint32_t i = 1; i <= last; ++i)
        make(unfolding_.child(instance, position, link, {i, last}));
      return true;
    });
  }

  const ComponentGraph& graph_;
  GraphUnfolding unfolding_;
  InstanceTree tree_;
};

}  // namespace

std::uint64_t count_instances(const ComponentGraph& graph, const InstanceLimits& limits) {
  return InstanceCounter(graph, limits).run();
}

InstanceTree make_instance_tree(const ComponentGraph& graph, const InstanceLimits& limits) {
  const std::uint64_t count = count_instances(graph, limits);
  if (count > limits.most_instances)
    throw InputError(
        fmt::format("the plant would have more than {} instances of components; lower "
                    "most_recursions, or the numbers of children and branches",
                    limits.most_instances));
  return InstanceMaker(graph, limits).run(count);
}

std::vector<std::uint64_t> instances_per_prototype(const ComponentGraph& graph,
                                                   const InstanceTree& tree) {
  std::vector<std::uint64_t> counts(graph.prototypes.size(), 0);
  for (const Instance& instance : tree.instances) ++counts[instance.prototype];
  return counts;
}

}  // namespace phytobench
