// SPDX-License-Identifier: MIT
// Curve reduction by [Liebemann2017] sec. 3.5, eq. 3.6, in the two orders that the text allows, and
// the narrowing of branching angles of sec. 3.4. Shares no code with core/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/oracles/liebemann2017_space_colonization.hpp"

namespace phytobench::oracles::liebemann2017 {

// Every node after its predecessor; -1 for the root, which comes first.
struct PlacedTree {
  std::vector<Point> nodes;
  std::vector<int> predecessors;
};

enum class ReductionOrder {
  simultaneous,  // every node is judged in the tree as it was
  root_to_tip,   // every node is judged in the tree that the nodes before it have left
};

// <R_1, R_2> of eq. 3.6 for a node v between v' and v_n.
inline double equation_3_6(Point v_prime, Point v, Point v_n) {
  const Point a = minus(v, v_prime), b = minus(v_n, v);
  return (a.x * b.x + a.y * b.y + a.z * b.z) / (norm(a) * norm(b));
}

// Nodes that stay, by their old numbers. A node goes if it has one predecessor and one successor
// and its scalar product is above the threshold.
inline std::vector<std::size_t> kept_nodes(const PlacedTree& tree, double threshold,
                                           ReductionOrder order) {
  const std::size_t n = tree.nodes.size();
  std::vector<int> successors(n, 0), successor(n, -1);
  for (std::size_t v = 1; v < n; ++v) {
    const auto p = static_cast<std::size_t>(tree.predecessors[v]);
    ++successors[p];
    successor[p] = static_cast<int>(v);
  }
  // A node has one successor before and after others have gone, so only predecessors change, and
  // going from the root to the tips the successor of the node to judge is still there.
  std::vector<int> predecessor = tree.predecessors;
  std::vector<std::size_t> kept;
  for (std::size_t v = 0; v < n; ++v) {
    bool goes = false;
    if (predecessor[v] >= 0 && successors[v] == 1) {
      const auto before = static_cast<std::size_t>(predecessor[v]);
      const auto behind = static_cast<std::size_t>(successor[v]);
      goes = equation_3_6(tree.nodes[before], tree.nodes[v], tree.nodes[behind]) > threshold;
    }
    if (!goes)
      kept.push_back(v);
    else if (order == ReductionOrder::root_to_tip)
      predecessor[static_cast<std::size_t>(successor[v])] = predecessor[v];
  }
  return kept;
}

// The tree of the nodes that stay; v_n becomes the successor of v'.
inline PlacedTree reduced(const PlacedTree& tree, double threshold, ReductionOrder order) {
  const std::vector<std::size_t> kept = kept_nodes(tree, threshold, order);
  std::vector<int> new_number(tree.nodes.size(), -1);
  PlacedTree smaller;
  for (const std::size_t v : kept) {
    int p = tree.predecessors[v];
    while (p >= 0 && new_number[static_cast<std::size_t>(p)] < 0)
      p = tree.predecessors[static_cast<std::size_t>(p)];
    new_number[v] = static_cast<int>(smaller.nodes.size());
    smaller.nodes.push_back(tree.nodes[v]);
    smaller.predecessors.push_back(p < 0 ? -1 : new_number[static_cast<std::size_t>(p)]);
  }
  return smaller;
}

// Nodes that an arc of `edges` equal edges keeps, which turns by t at each node, with the threshold
// cos(T): the chord of k edges makes the angle (k + 1) t / 2 with the next edge, so that from root
// to tip m edges become one. 0 < t, T in the same unit; 2 T / t not a whole number.
inline int nodes_kept_of_an_arc(int edges, double t, double T, ReductionOrder order) {
  if (order == ReductionOrder::simultaneous) return t < T ? 2 : edges + 1;
  const int m = std::max(1, static_cast<int>(std::ceil(2 * T / t - 1)));
  return (edges + m - 1) / m + 1;
}

// Sec. 3.4, step 3, gives no formula; by the paper that it cites every node moves half the way to
// its predecessor, as that stood before. The root stays.
inline PlacedTree narrowed(const PlacedTree& tree) {
  PlacedTree moved = tree;
  for (std::size_t v = 1; v < tree.nodes.size(); ++v) {
    const Point p = tree.nodes[static_cast<std::size_t>(tree.predecessors[v])];
    moved.nodes[v] = times(0.5, plus(tree.nodes[v], p));
  }
  return moved;
}

}  // namespace phytobench::oracles::liebemann2017
