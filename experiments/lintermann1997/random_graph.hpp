// SPDX-License-Identifier: MIT
// Random graphs of components without recursion, and the productions A ::= A_i B^n of
// [Lintermann1997] sec. 3.1 that say the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::experiments::lintermann1997 {

/// Edges lead from lower to higher numbers; every component but the first has one that leads to it.
struct RandomGraph {
  std::vector<int> multiplicity;                // per component; 1 for one that does not multiply
  std::vector<std::vector<std::size_t>> edges;  // targets per component

  RandomGraph(std::uint64_t seed, std::uint64_t number) {
    CounterStream random(seed, number);
    const auto size = static_cast<std::size_t>(random.next_between(2.0, 9.0));
    edges.resize(size);
    for (std::size_t i = 0; i < size; ++i)
      multiplicity.push_back(static_cast<int>(random.next_between(1, 4)));
    for (std::size_t to = 1; to < size; ++to) {
      const auto surely = static_cast<std::size_t>(random.next_between(0, static_cast<double>(to)));
      for (std::size_t from = 0; from < to; ++from)
        if (from == surely || random.next_unit() < 0.3) edges[from].push_back(to);
    }
  }

  ComponentGraph as_components() const {
    std::string text = "[graph]\nroot = \"c0\"\n";
    for (std::size_t i = 0; i < edges.size(); ++i)
      text += multiplicity[i] == 1 ? fmt::format("[component.c{}]\nkind = \"horn\"\n", i)
                                   : fmt::format("[component.c{}]\nkind = \"hydra\"\ncount = {}\n",
                                                 i, multiplicity[i]);
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (const std::size_t to : edges[i])
        text += fmt::format("[[link]]\nfrom = \"c{}\"\nto = \"c{}\"\n", i, to);
    return parse_component_graph(text, "random graph");
  }

  /// Capital letters are components, small ones their instances.
  LSystem as_productions() const {
    std::string text = "axiom: A\n";
    for (std::size_t i = 0; i < edges.size(); ++i) {
      text += fmt::format("{} ::= {}", letter('A', i), letter('a', i));
      for (const std::size_t to : edges[i])
        text += std::string(static_cast<std::size_t>(multiplicity[i]), letter('A', to));
      text += "\n";
    }
    return parse_lsystem(text, "productions of a graph");
  }

  static char letter(char first, std::size_t i) {
    return static_cast<char>(first + static_cast<int>(i));
  }
};

}  // namespace phytobench::experiments::lintermann1997
