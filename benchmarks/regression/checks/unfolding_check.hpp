// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/component_graph/instance_tree.hpp"

namespace phytobench {

/// A graph in which a multiplier stands inside a recursion: every turn makes three times as many.
std::string unfolding_text();

/// What is wrong with the i-tree of that graph, in one line; empty if nothing. Held against the
/// algorithm of [Lintermann1997] sec. 3.1 (corrected), which shares no code with core/: the same
/// prototypes below the same parents in the same order; and against the sum of powers.
std::string objection_to_unfolding(const ComponentGraph& graph, const InstanceTree& tree);

}  // namespace phytobench
