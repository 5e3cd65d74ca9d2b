// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/component_graph/component_graph.hpp"

namespace phytobench {

/// A node of the i-tree ([Lintermann1997] sec. 3.1).
struct Instance {
  std::uint32_t prototype = 0;
  std::uint32_t parent = 0;    ///< position in InstanceTree::instances; its own for the root
  std::uint32_t link = 0;      ///< position of the link that made it; any_link for the root
  std::uint32_t depth = 1;     ///< instances of its prototype on the way from the root, with itself
  SiblingNumber number;        ///< among those that the link made below the parent
  std::uint64_t identity = 0;  ///< see instance_identity.hpp
};

/// Parents stand before their children, and whole subtrees together, in the order of depth-first
/// search: per link in the graph's order, leaf links last, i from 1 to n.
struct InstanceTree {
  std::vector<Instance> instances;
};

struct InstanceLimits {
  /// A tree that would have more is refused, before any is made. 40 bytes each.
  std::uint64_t most_instances = 10'000'000;
  /// Instances on one way from the root; the walk calls itself so often.
  std::uint32_t most_levels = 2000;
};

/// How many instances the graph makes: the same recursion as below, but without the tree, counting
/// once and multiplying where siblings cannot differ. Stops at most_instances + 1. Throws
/// InputError for what recursion_problem() refuses, too many levels, and functions that leave their
/// range.
std::uint64_t count_instances(const ComponentGraph& graph, const InstanceLimits& limits = {});

/// Unfolds the graph. The recursion of [Lintermann1997] sec. 3.1 with three corrections, without
/// which its own example does not have the nine instances that the text counts: the counter of a
/// prototype is lowered again when its subtree is done, the test is <=, and a prototype without a
/// given limit is not limited. A nested recursion does not start anew in each turn of the outer
/// one: most_recursions counts along the whole way from the root.
///
/// Leaf links make their one instance where at least one child or branch of the same source was
/// refused because its prototype had reached its limit. Throws InputError as count_instances(), and
/// for more than limits.most_instances.
InstanceTree make_instance_tree(const ComponentGraph& graph, const InstanceLimits& limits = {});

/// How many instances each prototype has.
std::vector<std::uint64_t> instances_per_prototype(const ComponentGraph& graph,
                                                   const InstanceTree& tree);

/// The place of an instance, for the values of its parameters.
InstancePlace place_of(const ComponentGraph& graph, const Instance& instance);

}  // namespace phytobench
