// SPDX-License-Identifier: MIT
#include "core/component_graph/recursions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/component_graph/overlapping_recursions.hpp"

namespace phytobench {

namespace {

class RecursionChecker {
 public:
  explicit RecursionChecker(const ComponentGraph& graph)
      : graph_(graph), reached_(reached_prototypes(graph)) {}

  std::optional<GraphProblem> check() const {
    if (auto problem = endless_recursion()) return problem;
    for (std::size_t i = 0; i < graph_.links.size(); ++i)
      if (graph_.links[i].kind == LinkKind::leaf)
        if (auto problem = leaf_link_problem(i)) return problem;
    return overlap();
  }

 private:
  const std::string& name(std::size_t prototype) const { return graph_.prototypes[prototype].name; }

  bool is_limited(std::size_t prototype) const {
    return graph_.prototypes[prototype].most_recursions.has_value();
  }

  bool is_in_recursion(const ComponentLink& link) const {
    return link.from == link.to || reached_[link.to][link.from];
  }

  std::size_t link_between(std::size_t from, std::size_t to) const {
    const auto found =
        std::find_if(graph_.links.begin(), graph_.links.end(),
                     [&](const ComponentLink& link) { return link.from == from && link.to == to; });
    return static_cast<std::size_t>(found - graph_.links.begin());
  }

  std::string named(const std::vector<std::size_t>& cycle) const {
    std::string text;
    for (const std::size_t prototype : cycle) text += name(prototype) + " -> ";
    return text + name(cycle.front());
  }

  GraphProblem at_cycle(const std::vector<std::size_t>& cycle, std::string text) const {
    return {link_between(cycle.back(), cycle.front()), std::move(text)};
  }

  std::optional<GraphProblem> endless_recursion() const {
    PrototypeEdges edges(graph_.prototypes.size());
    for (const ComponentLink& link : graph_.links)
      if (!is_limited(link.from) && !is_limited(link.to)) edges.add(link.from, link.to);
    const std::vector<std::size_t> cycle = edges.shortest_cycle();
    if (cycle.empty()) return std::nullopt;
    return at_cycle(cycle,
                    fmt::format("the recursion {} never ends; give most_recursions to one of "
                                "its components",
                                named(cycle)));
  }

  std::optional<GraphProblem> leaf_link_problem(std::size_t position) const {
    const ComponentLink& leaf = graph_.links[position];
    if (is_in_recursion(leaf))
      return GraphProblem{
          position, fmt::format("the leaf link {} -> {} leads back into the recursion whose end it "
                                "marks; link to a component outside of it",
                                name(leaf.from), name(leaf.to))};
    bool is_recursive = false, may_be_last = false;
    for (const ComponentLink& link : graph_.links) {
      if (link.from != leaf.from || link.kind == LinkKind::leaf || !is_in_recursion(link)) continue;
      is_recursive = true;
      may_be_last = may_be_last || is_limited(link.to);
    }
    if (may_be_last) return std::nullopt;
    return GraphProblem{
        position,
        is_recursive
            ? fmt::format("the leaf link {0} -> {1} never makes anything: no component that "
                          "follows {0} in its recursion has most_recursions; give it to one, or "
                          "let the leaf link begin where the recursion ends",
                          name(leaf.from), name(leaf.to))
            : fmt::format("the leaf link {0} -> {1} never makes anything: {0} is in no recursion; "
                          "use kind = \"child\"",
                          name(leaf.from), name(leaf.to))};
  }

  std::optional<GraphProblem> overlap() const {
    PrototypeEdges edges(graph_.prototypes.size());
    for (const ComponentLink& link : graph_.links)
      if (is_in_recursion(link)) edges.add(link.from, link.to);
    const auto pair = overlapping_cycles(std::move(edges));
    if (!pair) return std::nullopt;
    return at_cycle(pair->second,
                    fmt::format("the recursions {} and {} overlap: they share components, and "
                                "neither holds all of the other; copy a component under another "
                                "name to take them apart",
                                named(pair->first), named(pair->second)));
  }

  const ComponentGraph& graph_;
  std::vector<std::vector<bool>> reached_;
};

}  // namespace

std::vector<std::vector<bool>> reached_prototypes(const ComponentGraph& graph) {
  const std::size_t count = graph.prototypes.size();
  PrototypeEdges edges(count);
  for (const ComponentLink& link : graph.links) edges.add(link.from, link.to);
  std::vector<std::vector<bool>> reached;
  for (std::size_t i = 0; i < count; ++i) reached.push_back(edges.reached_from(i));
  return reached;
}

std::optional<GraphProblem> recursion_problem(const ComponentGraph& graph) {
  return RecursionChecker(graph).check();
}

}  // namespace phytobench
