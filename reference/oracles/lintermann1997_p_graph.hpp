// SPDX-License-Identifier: MIT
// From the p-graph to the i-tree by the algorithm of [Lintermann1997] sec. 3.1, as printed and in
// the variants that its example of sec. 3.1.1 asks for, and the same as a grammar that counts.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "reference/oracles/lsystem_counts.hpp"

namespace phytobench::oracles::lintermann1997 {

// Sec. 4.1. A child-link goes to one instance, or to n from a multiplier component; a branch-link
// to as many as the component has branches; a leaf-link to one, where a recursion has ended.
enum class Link { child, branch, leaf };

struct Edge {
  std::string target;
  Link link = Link::child;
};

struct Prototype {
  int maximal_recursions = 1;
  int children = 1;  // n of a multiplier component
  int branches = 1;  // of a tree component
  std::vector<Edge> edges;
};

using PGraph = std::map<std::string, Prototype>;

enum class Comparison { less, less_or_equal };          // less is printed
enum class Counter { never_decremented, decremented };  // nothing that decrements is printed

// What "after the recursion has ended" comes to: the instance with which the counter reaches its
// limit, or every component that is refused at the limit, in whose place the leaf comes.
enum class LeafPlace { at_the_last_instance, for_each_refusal };

struct Reading {
  Comparison comparison = Comparison::less_or_equal;
  Counter counter = Counter::decremented;
  LeafPlace leaf_place = LeafPlace::at_the_last_instance;
};
inline constexpr Reading as_printed{Comparison::less, Counter::never_decremented, {}};

// Instances in the order of their creation.
struct ITree {
  std::vector<std::string> prototypes;
  std::vector<int> parents;  // -1: none
  bool cut_off = false;      // there would be more than the caller allowed

  std::size_t instances() const { return prototypes.size(); }
  std::size_t edges() const;
  int count(const std::string& prototype) const;
};

ITree i_tree(const PGraph& graph, const std::string& root, const Reading& reading,
             std::size_t most_instances);

// "A ::= A_i B^n": a letter for each prototype and for the counters with which it is reached, and a
// letter "name_i" for its instances. For the default reading only; there may be many letters.
D0LStructure counting_grammar(const PGraph& graph, const std::string& root);

// Instances of each prototype by that grammar, derived until nothing is left to be replaced.
std::map<std::string, Natural> instances_by_grammar(const PGraph& graph, const std::string& root);

}  // namespace phytobench::oracles::lintermann1997
