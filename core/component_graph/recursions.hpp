// SPDX-License-Identifier: MIT
// What is allowed of the loops in a graph of components ([Lintermann1997] sec. 3.1).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/component_graph/component_graph.hpp"

namespace phytobench {

struct GraphProblem {
  std::size_t link = 0;  ///< position of the link that messages point to
  std::string text;
};

/// Refuses, in this order:
/// - a recursion none of whose components has most_recursions: it would never end;
/// - a leaf link that never makes an instance, because its source is in no recursion or never the
///   last of one;
/// - a leaf link that leads back into the recursion whose end it marks;
/// - overlapping recursions, which share components while neither holds all of the other. The paper
///   allows nested ones only.
std::optional<GraphProblem> recursion_problem(const ComponentGraph& graph);

/// reached[a][b]: whether links (one or more) lead from prototype a to prototype b.
std::vector<std::vector<bool>> reached_prototypes(const ComponentGraph& graph);

}  // namespace phytobench
