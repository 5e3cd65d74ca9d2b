// SPDX-License-Identifier: MIT
#include "core/component_graph/prototype_edges.hpp"

#include <algorithm>

namespace phytobench {

bool PrototypeEdges::has(std::size_t from, std::size_t to) const {
  return std::find(to_[from].begin(), to_[from].end(), to) != to_[from].end();
}

void PrototypeEdges::add(std::size_t from, std::size_t to) {
  if (!has(from, to)) to_[from].push_back(to);
}

void PrototypeEdges::remove(std::size_t from, std::size_t to) {
  std::erase(to_[from], to);
}

std::vector<bool> PrototypeEdges::reached_from(std::size_t node) const {
  std::vector<bool> reached(size(), false);
  std::vector<std::size_t> waiting{node};
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    for (const std::size_t next : to_[at]) {
      if (reached[next]) continue;
      reached[next] = true;
      waiting.push_back(next);
    }
  }
  return reached;
}

std::vector<std::size_t> PrototypeEdges::shortest_way(std::size_t from, std::size_t to) const {
  const std::size_t unseen = size();
  std::vector<std::size_t> before(size(), unseen);
  std::vector<std::size_t> queue{from};
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t at = queue[head];
    if (has(at, to)) {
      // Back from the last node before `to`.
      std::vector<std::size_t> way;
      if (from != to) way.push_back(to);
      for (std::size_t node = at; node != from; node = before[node]) way.push_back(node);
      way.push_back(from);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const std::size_t next : to_[at]) {
      if (next == from || before[next] != unseen) continue;
      before[next] = at;
      queue.push_back(next);
    }
  }
  return {};
}

std::vector<std::size_t> PrototypeEdges::shortest_cycle() const {
  std::vector<std::size_t> shortest;
  for (std::size_t node = 0; node < size() && shortest.size() != 1; ++node) {
    std::vector<std::size_t> cycle = shortest_way(node, node);
    if (!cycle.empty() && (shortest.empty() || cycle.size() < shortest.size()))
      shortest = std::move(cycle);
  }
  return shortest;
}

}  // namespace phytobench
