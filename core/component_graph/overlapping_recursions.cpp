// SPDX-License-Identifier: MIT
#include "core/component_graph/overlapping_recursions.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

using Nodes = std::vector<std::size_t>;

bool holds(const Nodes& nodes, std::size_t node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

class CycleShrinker {
 public:
  explicit CycleShrinker(PrototypeEdges edges) : edges_(std::move(edges)) {
    for (std::size_t i = 0; i < edges_.size(); ++i) members_.push_back({i});
  }

  std::optional<std::pair<Nodes, Nodes>> run() {
    for (Nodes cycle = edges_.shortest_cycle(); !cycle.empty(); cycle = edges_.shortest_cycle()) {
      const std::vector<Edge> crossing = crossing_edges(cycle);
      if (auto pair = overlap(cycle, crossing)) return pair;
      shrink(std::move(cycle), crossing);
    }
    return std::nullopt;
  }

 private:
  struct Edge {
    std::size_t from, to;
  };

  /// Those that enter or leave the cycle.
  std::vector<Edge> crossing_edges(const Nodes& cycle) const {
    std::vector<Edge> edges;
    for (std::size_t from = 0; from < edges_.size(); ++from)
      for (const std::size_t to : edges_.from(from))
        if (holds(cycle, from) != holds(cycle, to)) edges.push_back({from, to});
    return edges;
  }

  std::optional<std::pair<Nodes, Nodes>> overlap(const Nodes& cycle,
                                                 const std::vector<Edge>& crossing) const {
    Nodes first_through, first_entered;
    for (const Edge& edge : crossing) {
      const Nodes through = edges_.shortest_way(edge.to, edge.from);
      if (through.empty()) continue;  // its cycle has been shrunk
      if (!std::all_of(cycle.begin(), cycle.end(),
                       [&](std::size_t node) { return holds(through, node); }))
        return std::pair{expanded(cycle), expanded(through)};
      // It goes through the whole cycle, once: the entry says where it leaves, too.
      const Nodes entered = entry(cycle, through);
      if (first_entered.empty()) {
        first_through = through;
        first_entered = entered;
      } else if (entered != first_entered) {
        return std::pair{expanded(first_through), expanded(through)};
      }
    }
    return std::nullopt;
  }

  /// The node at which a closed way enters the cycle.
  static Nodes entry(const Nodes& cycle, const Nodes& way) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      const std::size_t before = way[(i + way.size() - 1) % way.size()];
      if (holds(cycle, way[i]) && !holds(cycle, before)) return {way[i]};
    }
    return {};
  }

  /// Its first node takes the edges and names of all.
  void shrink(Nodes cycle, const std::vector<Edge>& crossing) {
    const auto entering = std::find_if(crossing.begin(), crossing.end(),
                                       [&](const Edge& edge) { return holds(cycle, edge.to); });
    if (entering != crossing.end())
      std::rotate(cycle.begin(), std::find(cycle.begin(), cycle.end(), entering->to), cycle.end());
    const std::size_t kept = cycle.front();
    for (const std::size_t node : cycle)
      for (const std::size_t next : Nodes(edges_.from(node))) edges_.remove(node, next);
    for (const Edge& edge : crossing) {
      const bool enters = holds(cycle, edge.to);
      if (enters) edges_.remove(edge.from, edge.to);
      enters ? edges_.add(edge.from, kept) : edges_.add(kept, edge.to);
    }
    members_[kept] = expanded(cycle);
  }

  Nodes expanded(const Nodes& cycle) const {
    Nodes all;
    for (const std::size_t node : cycle)
      all.insert(all.end(), members_[node].begin(), members_[node].end());
    return all;
  }

  PrototypeEdges edges_;
  std::vector<Nodes> members_;  // in the order of the way through them
};

}  // namespace

std::optional<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> overlapping_cycles(
    PrototypeEdges edges) {
  return CycleShrinker(std::move(edges)).run();
}

}  // namespace phytobench
