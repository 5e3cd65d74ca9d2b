// SPDX-License-Identifier: MIT
// The tree graph of [Liebemann2017] sec. 2.4.1, branch depths by eq. 3.5 and radii by eq. 3.4.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace phytobench::oracles::liebemann2017 {

// Nodes in the order of their creation: the root, without predecessor (-1), comes first, and every
// node after its predecessor.
struct TreeGraph {
  std::vector<int> predecessors;
  std::vector<std::vector<int>> successors;

  explicit TreeGraph(const std::vector<int>& of) : predecessors(of), successors(of.size()) {
    for (std::size_t v = 1; v < of.size(); ++v)
      successors[static_cast<std::size_t>(of[v])].push_back(static_cast<int>(v));
  }
  std::size_t nodes() const { return predecessors.size(); }
  std::size_t edges() const {
    std::size_t sum = 0;
    for (const auto& s : successors) sum += s.size();
    return sum;
  }
  std::size_t predecessor(std::size_t v) const { return static_cast<std::size_t>(predecessors[v]); }
};

// One root, and every node after its predecessor: no cycle is possible then.
inline bool is_tree(const std::vector<int>& predecessors) {
  if (predecessors.empty() || predecessors[0] != -1) return false;
  for (std::size_t v = 1; v < predecessors.size(); ++v)
    if (predecessors[v] < 0 || predecessors[v] >= static_cast<int>(v)) return false;
  return true;
}

using Histogram = std::map<int, int>;  // value -> how many nodes

inline Histogram histogram(const std::vector<int>& values) {
  Histogram times;
  for (const int value : values) ++times[value];
  return times;
}

// "Grad": the number of successors.
inline std::vector<int> degrees(const TreeGraph& G) {
  std::vector<int> degree;
  for (const auto& successors : G.successors) degree.push_back(static_cast<int>(successors.size()));
  return degree;
}

inline std::vector<std::size_t> tips(const TreeGraph& G) {
  std::vector<std::size_t> all;
  for (std::size_t v = 0; v < G.nodes(); ++v)
    if (G.successors[v].empty()) all.push_back(v);
  return all;
}

// "Tiefe": predecessors on the way to the root.
inline std::vector<int> depths(const TreeGraph& G) {
  std::vector<int> depth(G.nodes(), 0);
  for (std::size_t v = 1; v < G.nodes(); ++v) depth[v] = depth[G.predecessor(v)] + 1;
  return depth;
}

// Eq. 3.5 "directly after the creation of the node", when v counts as a successor of v' already:
// the first one inherits Z(v'), every later one gets one more.
inline std::vector<int> branch_depths_at_creation(const TreeGraph& G) {
  std::vector<int> Z(G.nodes(), 0), so_far(G.nodes(), 0);
  for (std::size_t v = 1; v < G.nodes(); ++v) {
    const std::size_t v_prime = G.predecessor(v);
    ++so_far[v_prime];
    Z[v] = so_far[v_prime] == 1 ? Z[v_prime] : 1 + Z[v_prime];
  }
  return Z;
}

// Eq. 3.5 on the finished tree: at a fork all get one more.
inline std::vector<int> branch_depths_when_finished(const TreeGraph& G) {
  std::vector<int> Z(G.nodes(), 0);
  for (std::size_t v = 1; v < G.nodes(); ++v) {
    const std::size_t v_prime = G.predecessor(v);
    Z[v] = G.successors[v_prime].size() == 1 ? Z[v_prime] : 1 + Z[v_prime];
  }
  return Z;
}

// Eq. 3.4, from the tips with r_0 down to the root.
inline std::vector<double> radii(const TreeGraph& G, double r_0, double g) {
  std::vector<double> r(G.nodes(), r_0);
  for (std::size_t v = G.nodes(); v-- > 0;) {
    if (G.successors[v].empty()) continue;
    double sum = 0;
    for (const int n : G.successors[v]) sum += std::pow(r[static_cast<std::size_t>(n)], g);
    r[v] = std::pow(sum, 1 / g);
  }
  return r;
}

// What eq. 3.4 comes to: r^g = tips r_0^g.
inline double radius_above_tips(std::size_t tips, double r_0, double g) {
  return r_0 * std::pow(static_cast<double>(tips), 1 / g);
}

inline int greatest(const std::vector<int>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace phytobench::oracles::liebemann2017
