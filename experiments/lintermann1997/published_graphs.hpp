// SPDX-License-Identifier: MIT
// The p-graphs of [Lintermann1997] sec. 3.1.1 and 5.3, as graphs of the suite.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/instance_tree.hpp"

namespace phytobench::experiments::lintermann1997 {

/// Sec. 3.1.1: root A, stem B, multiplier C by three, and D, a part of a branch. `more` is added to
/// the text: links that close a loop, and other components.
inline ComponentGraph published_example(int recursions_of_D, std::string_view more,
                                        std::string_view of_C = "") {
  return parse_component_graph(
      fmt::format("[graph]\nroot = \"A\"\n"
                  "[component.A]\nkind = \"simple\"\nshape = \"none\"\n"
                  "[component.B]\nkind = \"horn\"\n"
                  "[component.C]\nkind = \"hydra\"\ncount = 3\n{}\n"
                  "[component.D]\nkind = \"horn\"\n{}\n"
                  "[[link]]\nfrom = \"A\"\nto = \"B\"\n"
                  "[[link]]\nfrom = \"B\"\nto = \"C\"\n"
                  "[[link]]\nfrom = \"C\"\nto = \"D\"\n"
                  "{}",
                  of_C,
                  recursions_of_D > 0 ? fmt::format("most_recursions = {}", recursions_of_D)
                                      : std::string(),
                  more),
      "sec. 3.1.1");
}

/// D follows itself.
inline constexpr std::string_view loop_of_D = "[[link]]\nfrom = \"D\"\nto = \"D\"\n";
/// D goes back to the multiplier.
inline constexpr std::string_view loop_through_C = "[[link]]\nfrom = \"D\"\nto = \"C\"\n";

/// Sec. 5.3: a phiball by three and a tree, which follow each other five times.
inline ComponentGraph published_bush(std::string_view limited) {
  const auto limit = [&](std::string_view name) {
    return name == limited ? "most_recursions = 5\n" : "";
  };
  return parse_component_graph(fmt::format("[graph]\nroot = \"phiball\"\n"
                                           "[component.phiball]\nkind = \"phiball\"\ncount = 3\n{}"
                                           "[component.tree]\nkind = \"tree\"\n{}"
                                           "[[link]]\nfrom = \"phiball\"\nto = \"tree\"\n"
                                           "[[link]]\nfrom = \"tree\"\nto = \"phiball\"\n",
                                           limit("phiball"), limit("tree")),
                               "sec. 5.3");
}

/// Instances of the prototype of that name.
inline std::int64_t instances_of(const ComponentGraph& graph, const InstanceTree& tree,
                                 std::string_view name) {
  const std::vector<std::uint64_t> counts = instances_per_prototype(graph, tree);
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (graph.prototypes[i].name == name) return static_cast<std::int64_t>(counts[i]);
  return -1;
}

}  // namespace phytobench::experiments::lintermann1997
