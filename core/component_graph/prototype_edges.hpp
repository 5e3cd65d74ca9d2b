// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace phytobench {

/// A directed graph of numbered nodes, each edge once. Small: the nodes are prototypes.
class PrototypeEdges {
 public:
  explicit PrototypeEdges(std::size_t nodes) : to_(nodes) {}

  void add(std::size_t from, std::size_t to);
  void remove(std::size_t from, std::size_t to);
  bool has(std::size_t from, std::size_t to) const;
  std::size_t size() const { return to_.size(); }
  const std::vector<std::size_t>& from(std::size_t node) const { return to_[node]; }

  /// The nodes that one or more edges lead to.
  std::vector<bool> reached_from(std::size_t node) const;
  /// The nodes of a shortest way, both ends included; at least one edge, so that from = to asks for
  /// a cycle (whose first node is not repeated at its end). Empty if there is none.
  std::vector<std::size_t> shortest_way(std::size_t from, std::size_t to) const;
  /// Empty if there is no cycle.
  std::vector<std::size_t> shortest_cycle() const;

 private:
  std::vector<std::vector<std::size_t>> to_;
};

}  // namespace phytobench
