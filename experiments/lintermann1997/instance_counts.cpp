// SPDX-License-Identifier: MIT
// How many instances the graphs of sec. 3.1.1, 4.1 and 5.3 make, and how they hang together.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/instance_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "experiments/lintermann1997/published_graphs.hpp"
#include "reference/oracles/lintermann1997_p_graph.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

oracle::PGraph literal_example(int recursions_of_D) {
  oracle::PGraph graph;
  graph["A"] = {.maximal_recursions = 1, .children = 1, .branches = 1, .edges = {{"B"}}};
  graph["B"] = {.maximal_recursions = 1, .children = 1, .branches = 1, .edges = {{"C"}}};
  graph["C"] = {.maximal_recursions = 1, .children = 3, .branches = 1, .edges = {{"D"}}};
  graph["D"] = {
      .maximal_recursions = recursions_of_D, .children = 1, .branches = 1, .edges = {{"D"}}};
  return graph;
}

/// D below C, and D below D.
void record_links_of_D(ExperimentContext& context, const ComponentGraph& graph,
                       const InstanceTree& tree) {
  std::vector<std::int64_t> at_depth(5, 0);
  std::int64_t below_C = 0, in_a_chain = 0;
  const auto name = [&](const Instance& instance) -> const std::string& {
    return graph.prototypes[instance.prototype].name;
  };
  for (const Instance& instance : tree.instances) {
    if (name(instance) != "D") continue;
    ++at_depth.at(instance.depth);
    const Instance& parent = tree.instances[instance.parent];
    below_C += name(parent) == "C" && instance.depth == 1 && instance.number.n == 3;
    in_a_chain += name(parent) == "D" && parent.depth + 1 == instance.depth;
  }
  for (std::size_t depth = 1; depth <= 3; ++depth)
    context.record(fmt::format("example/D_at_depth_{}", depth), at_depth[depth]);
  context.record("example/D_below_C", below_C);
  context.record("example/D_below_D_one_deeper", in_a_chain);
}

void record_example(ExperimentContext& context) {
  const ComponentGraph graph = published_example(3, loop_of_D);
  const InstanceTree tree = make_instance_tree(graph);
  for (const char* name : {"A", "B", "C", "D"})
    context.record(fmt::format("example/{}", name), instances_of(graph, tree, name));
  context.record("example/instances", static_cast<std::int64_t>(tree.instances.size()));
  context.record("example/levels", std::int64_t{level_count(tree)});
  record_links_of_D(context, graph, tree);
}

/// D follows itself, or leads back to the multiplier; the limit at D or at C.
void record_loops(ExperimentContext& context) {
  std::int64_t differing = 0;
  for (int limit = 1; limit <= 6; ++limit) {
    const ComponentGraph graph = published_example(limit, loop_of_D);
    const InstanceTree tree = make_instance_tree(graph);
    context.record(fmt::format("limit-{}/D", limit), instances_of(graph, tree, "D"));
    const oracle::ITree literal = oracle::i_tree(literal_example(limit), "A", {}, 1000);
    differing += literal.instances() != tree.instances.size();
  }
  context.record("differs_from_oracle", differing);
  const ComponentGraph at_D = published_example(3, loop_through_C);
  const ComponentGraph at_C = published_example(0, loop_through_C, "most_recursions = 3");
  const InstanceTree by_D = make_instance_tree(at_D), by_C = make_instance_tree(at_C);
  context.record("multiplier_in_the_loop/limit_at_D/D", instances_of(at_D, by_D, "D"));
  context.record("multiplier_in_the_loop/limit_at_D/C", instances_of(at_D, by_D, "C"));
  context.record("multiplier_in_the_loop/limit_at_C/D", instances_of(at_C, by_C, "D"));
  context.record("multiplier_in_the_loop/limit_at_C/C", instances_of(at_C, by_C, "C"));
}

/// Instances E at leaf links of sec. 4.1: where the chains of D end, and in a loop through C.
void record_leaf_links(ExperimentContext& context) {
  constexpr std::string_view leaf =
      "[component.E]\nkind = \"leaf\"\n[[link]]\nfrom = \"{}\"\nto = \"E\"\nkind = \"leaf\"\n";
  const std::string at_D = std::string(loop_of_D) + fmt::format(fmt::runtime(leaf), "D");
  const std::string at_C = std::string(loop_through_C) + fmt::format(fmt::runtime(leaf), "C");
  const ComponentGraph chain = published_example(3, at_D), loop = published_example(3, at_C);
  const InstanceTree of_chain = make_instance_tree(chain), of_loop = make_instance_tree(loop);
  context.record("leaf_link/chain/E", instances_of(chain, of_chain, "E"));
  context.record("leaf_link/multiplier_in_the_loop/E", instances_of(loop, of_loop, "E"));
  std::int64_t elsewhere = 0;
  for (const Instance& instance : of_chain.instances)
    if (chain.prototypes[instance.prototype].name == "E")
      elsewhere += of_chain.instances[instance.parent].depth != 3;
  context.record("leaf_link/chain/E_before_the_end", elsewhere);
}

/// A tree component with both kinds of links of sec. 4.1.
void record_child_and_branch_links(ExperimentContext& context) {
  const ComponentGraph graph = parse_component_graph(
      "[graph]\nroot = \"trunk\"\n"
      "[component.trunk]\nkind = \"tree\"\nbranches = 7\n"
      "[component.top]\nkind = \"horn\"\n[component.twig]\nkind = \"horn\"\n"
      "[[link]]\nfrom = \"trunk\"\nto = \"top\"\n"
      "[[link]]\nfrom = \"trunk\"\nto = \"twig\"\nkind = \"branch\"\n",
      "sec. 4.1");
  const InstanceTree tree = make_instance_tree(graph);
  context.record("tree_with_7_branches/by_child_link", instances_of(graph, tree, "top"));
  context.record("tree_with_7_branches/by_branch_link", instances_of(graph, tree, "twig"));
}

void record_bush(ExperimentContext& context) {
  for (const char* limited : {"phiball", "tree"}) {
    const ComponentGraph graph = published_bush(limited);
    const InstanceTree tree = make_instance_tree(graph);
    for (const char* name : {"phiball", "tree"})
      context.record(fmt::format("bush/limit_at_{}/{}", limited, name),
                     instances_of(graph, tree, name));
  }
  const LSystem system = bush_system(bush_of_the_book());
  context.record("bush/groups_of_the_lsystem",
                 static_cast<std::int64_t>(
                     symbol_counts(system, derived(system, 5))[*find_symbol(system, "!", 0)]));
}

void run(ExperimentContext& context) {
  record_example(context);
  record_loops(context);
  record_leaf_links(context);
  record_child_and_branch_links(context);
  record_bush(context);
}

}  // namespace

extern const ExperimentDescriptor instance_counts;
constinit const ExperimentDescriptor instance_counts{
    .id = "lintermann1997/instance-counts",
    .question = "How many instances do the graphs of the article make?",
    .source = "[Lintermann1997] sec. 3.1.1, 4.1 and 5.3, fig. 2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
