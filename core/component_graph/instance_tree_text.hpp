// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/component_graph/instance_tree.hpp"

namespace phytobench {

/// A line for each instance, two spaces deeper than its parent: "branch 2/3", the second of three
/// that a link has made; "branch #4": the fourth of its prototype on the way from the root.
std::string instance_tree_list(const ComponentGraph& graph, const InstanceTree& tree);

/// The same for Graphviz. Branch links are dashed, leaf links dotted.
std::string instance_tree_dot(const ComponentGraph& graph, const InstanceTree& tree);

}  // namespace phytobench
