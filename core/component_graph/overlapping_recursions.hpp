// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/component_graph/prototype_edges.hpp"

namespace phytobench {

/// Two cycles that share nodes although neither holds all nodes of the other, as their nodes in
/// order; nothing if all cycles are nested or apart. `edges` holds only edges that lie on cycles.
///
/// A shortest cycle C has no short cuts. If all others are nested or apart, one that meets C goes
/// through all of it, so it enters at one node and leaves at the node before; C may then be shrunk
/// to one node without changing how the others lie. So each step shrinks one cycle, instead of
/// listing all of them, of which there may be exponentially many.
std::optional<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> overlapping_cycles(
    PrototypeEdges edges);

}  // namespace phytobench
