// SPDX-License-Identifier: MIT
// How many instances of each component a p-graph makes, by counting alone: a component is read as a
// production A ::= A_i B^n ([Lintermann1997] sec. 3.1), whose letters carry how deep in its
// recursion each component is. Other than in lintermann1997_p_graph.hpp the n may differ with that
// depth and among siblings, and a leaf comes where a successor of the component is refused. Shares
// no code with core/, so that agreement means something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reference/oracles/lintermann1997_p_graph.hpp"

namespace phytobench::oracles::lintermann1997 {

struct CountedEdge {
  std::size_t target = 0;
  Link link = Link::child;
};

// Which of its n siblings an instance is, 1 ... n.
struct Sibling {
  std::uint64_t i = 1;
  std::uint64_t n = 1;
};

struct CountedComponent {
  std::optional<int> maximal_recursions;  // absent: any number
  std::vector<CountedEdge> edges;
  // The n of an edge of that kind below the depth-th instance of its component on the way from the
  // root. Asked without a sibling: nothing if it matters which. With one: nothing if chance
  // decides.
  std::function<std::optional<std::uint64_t>(Link, int depth, const std::optional<Sibling>&)> times;
};

// Nothing where chance decides; 2^64 - 1 stands for all that is not less.
using InstanceCounts = std::vector<std::optional<std::uint64_t>>;

// For every component. Nothing at all if there would be more productions. Every recursion ends.
std::optional<InstanceCounts> instance_counts(const std::vector<CountedComponent>& graph,
                                              std::size_t root, std::size_t most_productions);

}  // namespace phytobench::oracles::lintermann1997
