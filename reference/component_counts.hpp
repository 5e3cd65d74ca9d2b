// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/component_graph/component_graph.hpp"

namespace phytobench {

/// What a grammar that only counts, A ::= A_i B^n ([Lintermann1997] sec. 3.1), says of a graph.
struct PredictedCounts {
  /// Instances of each prototype; absent where random() decides on a number of children or branches
  /// above it.
  std::vector<std::optional<std::uint64_t>> instances;
  /// The grammar would be too large; then all are absent.
  bool is_too_large = false;
};

/// Translates the graph for an oracle that shares no code with make_instance_tree(): of core, only
/// the components' own functions are asked how many children and branches they make. Every
/// recursion must end, and levels be as few as make_instance_tree() allows.
PredictedCounts predicted_counts(const ComponentGraph& graph);

/// What the numbers of instances made, one for each prototype, have against the prediction, in one
/// line; empty if nothing.
std::string count_disagreement(const ComponentGraph& graph, std::span<const std::uint64_t> made,
                               const PredictedCounts& predicted);

}  // namespace phytobench
