// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/unfolding_check.hpp"

#include <fmt/format.h>

#include "reference/oracles/lintermann1997_p_graph.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {

namespace {

namespace oracle = oracles::lintermann1997;

constexpr int turns = 8;
constexpr int children = 3;

oracle::ITree literal_tree() {
  constexpr int unlimited = 1'000'000;
  oracle::PGraph graph;
  graph["A"] = {unlimited, 1, 1, {{"C", oracle::Link::child}}};
  graph["C"] = {unlimited, children, 1, {{"D", oracle::Link::child}}};
  graph["D"] = {turns, 1, 1, {{"C", oracle::Link::child}}};
  return oracle::i_tree(graph, "A", {}, 1'000'000);
}

}  // namespace

std::string unfolding_text() {
  return fmt::format(
      "[graph]\nroot = \"A\"\n"
      "[component.A]\nkind = \"simple\"\n"
      "[component.C]\nkind = \"hydra\"\ncount = {}\n"
      "[component.D]\nkind = \"simple\"\nmost_recursions = {}\n"
      "[[link]]\nfrom = \"A\"\nto = \"C\"\n"
      "[[link]]\nfrom = \"C\"\nto = \"D\"\n"
      "[[link]]\nfrom = \"D\"\nto = \"C\"\n",
      children, turns);
}

std::string objection_to_unfolding(const ComponentGraph& graph, const InstanceTree& tree) {
  const std::uint64_t powers = children * oracles::replacements(children, turns);
  const std::uint64_t all = 1 + (1 + powers) + powers;  // A, each C, each D
  if (tree.instances.size() != all)
    return fmt::format("{} instances instead of {}", tree.instances.size(), all);
  const oracle::ITree expected = literal_tree();
  if (expected.instances() != all) return "the literal algorithm makes another number";
  for (std::size_t i = 0; i < all; ++i) {
    const Instance& instance = tree.instances[i];
    const int parent = i == 0 ? -1 : static_cast<int>(instance.parent);
    if (graph.prototypes[instance.prototype].name != expected.prototypes[i])
      return fmt::format("instance {} is of '{}' instead of '{}'", i,
                         graph.prototypes[instance.prototype].name, expected.prototypes[i]);
    if (parent != expected.parents[i])
      return fmt::format("instance {} hangs on {} instead of {}", i, parent, expected.parents[i]);
  }
  return "";
}

}  // namespace phytobench
