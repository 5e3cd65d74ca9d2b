// SPDX-License-Identifier: MIT
#include "reference/oracles/lintermann1997_p_graph.hpp"

#include <algorithm>

namespace phytobench::oracles::lintermann1997 {

namespace {

using NamedCounters = std::map<std::string, int>;

// How many instances an edge of Q asks for.
int times(const Prototype& Q, const Edge& edge) {
  if (edge.link == Link::leaf) return 1;
  return edge.link == Link::child ? Q.children : Q.branches;
}

struct Instantiation {
  const PGraph& graph;
  const Reading& reading;
  std::size_t most;
  NamedCounters depth;  // "Rekursionstiefe"
  ITree tree;

  bool allowed(int recursion_depth, const Prototype& Q) const {
    return reading.comparison == Comparison::less ? recursion_depth < Q.maximal_recursions
                                                  : recursion_depth <= Q.maximal_recursions;
  }

  void create_leaves(const Prototype& Q, int parent) {
    for (const Edge& edge : Q.edges)
      if (edge.link == Link::leaf) create_subtree(edge.target, parent);
  }

  // "ErzeugeTeilbaum".
  void create_subtree(const std::string& name, int parent) {
    const Prototype& Q = graph.at(name);
    ++depth[name];
    if (allowed(depth[name], Q)) {
      if (tree.instances() >= most) {
        tree.cut_off = true;
        return;
      }
      tree.prototypes.push_back(name);
      tree.parents.push_back(parent);
      const int instance = static_cast<int>(tree.instances()) - 1;
      const bool last = !allowed(depth[name] + 1, Q);
      for (const Edge& edge : Q.edges)
        if (edge.link != Link::leaf)
          for (int i = 0; i < times(Q, edge) && !tree.cut_off; ++i)
            create_subtree(edge.target, instance);
      if (last && reading.leaf_place == LeafPlace::at_the_last_instance) create_leaves(Q, instance);
    } else if (reading.leaf_place == LeafPlace::for_each_refusal) {
      create_leaves(Q, parent);
    }
    if (reading.counter == Counter::decremented) --depth[name];
  }
};

std::string nonterminal(const std::string& name, const NamedCounters& counters) {
  std::string letter = name + " after";
  for (const auto& [prototype, count] : counters)
    if (count > 0) letter += " " + prototype + ":" + std::to_string(count);
  return letter;
}

std::string terminal(const std::string& name) {
  return name + "_i";
}

// The production of a prototype that is reached with these counters, and all that it needs.
void add_production(const PGraph& graph, const std::string& name, const NamedCounters& counters,
                    D0LStructure& grammar) {
  const std::string letter = nonterminal(name, counters);
  if (grammar.successors.contains(letter)) return;
  grammar.successors[letter] = {};
  const Prototype& Q = graph.at(name);
  NamedCounters inside = counters;
  ++inside[name];
  if (inside[name] > Q.maximal_recursions) return;  // the letter vanishes
  std::vector<std::string> successor{terminal(name)};
  for (const Edge& edge : Q.edges) {
    if (edge.link == Link::leaf && inside[name] < Q.maximal_recursions) continue;
    for (int i = 0; i < times(Q, edge); ++i) successor.push_back(nonterminal(edge.target, inside));
    add_production(graph, edge.target, inside, grammar);
  }
  grammar.successors[letter] = successor;
}

}  // namespace

std::size_t ITree::edges() const {
  return instances() - static_cast<std::size_t>(std::count(parents.begin(), parents.end(), -1));
}

int ITree::count(const std::string& prototype) const {
  return static_cast<int>(std::count(prototypes.begin(), prototypes.end(), prototype));
}

ITree i_tree(const PGraph& graph, const std::string& root, const Reading& reading,
             std::size_t most_instances) {
  Instantiation instantiation{graph, reading, most_instances, {}, {}};
  instantiation.create_subtree(root, -1);
  return instantiation.tree;
}

D0LStructure counting_grammar(const PGraph& graph, const std::string& root) {
  D0LStructure grammar{{nonterminal(root, {})}, {}};
  add_production(graph, root, {}, grammar);
  return grammar;
}

std::map<std::string, Natural> instances_by_grammar(const PGraph& graph, const std::string& root) {
  D0LStructure grammar = counting_grammar(graph, root);
  LetterCounts counts = letter_counts(grammar, 0);
  for (int n = 1;; ++n) {
    const LetterCounts next = letter_counts(grammar, n);
    if (next == counts) break;
    counts = next;
  }
  std::map<std::string, Natural> instances;
  for (const auto& [name, prototype] : graph) instances[name] = count_of(counts, terminal(name));
  return instances;
}

}  // namespace phytobench::oracles::lintermann1997
