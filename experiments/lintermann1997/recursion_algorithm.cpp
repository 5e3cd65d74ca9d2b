// SPDX-License-Identifier: MIT
// The algorithm of sec. 3.1 on the example of sec. 3.1.1: as printed, and with what its own example
// asks for, beside the suite's engine.
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/published_graphs.hpp"
#include "reference/oracles/lintermann1997_p_graph.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

/// A, B and C have the limit `others`, D has `of_D`.
oracle::PGraph literal_example(int others, int of_D) {
  const auto component = [](int limit, int children, const char* target) {
    oracle::Prototype prototype;
    prototype.maximal_recursions = limit;
    prototype.children = children;
    prototype.edges = {{target}};
    return prototype;
  };
  oracle::PGraph graph;
  graph["A"] = component(others, 1, "B");
  graph["B"] = component(others, 1, "C");
  graph["C"] = component(others, 3, "D");
  graph["D"] = component(of_D, 1, "D");
  return graph;
}

int subtrees_of_C(const oracle::ITree& tree) {
  int count = 0;
  for (std::size_t i = 0; i < tree.instances(); ++i)
    count +=
        tree.parents[i] >= 0 && tree.prototypes[static_cast<std::size_t>(tree.parents[i])] == "C";
  return count;
}

void record(ExperimentContext& context, const std::string& name, const oracle::Reading& reading) {
  constexpr int enough = 9;  // never reached by A, B and C
  constexpr std::size_t most = 1000;
  for (int limit = 1; limit <= 6; ++limit) {
    const oracle::ITree tree = oracle::i_tree(literal_example(enough, limit), "A", reading, most);
    context.record(fmt::format("{}/limit-{}/D", name, limit), std::int64_t{tree.count("D")});
    if (limit == 3) context.record(name + "/subtrees_of_C", std::int64_t{subtrees_of_C(tree)});
  }
  const oracle::ITree all_one = oracle::i_tree(literal_example(1, 1), "A", reading, most);
  context.record(name + "/all_limits_1/instances", static_cast<std::int64_t>(all_one.instances()));
}

void run(ExperimentContext& context) {
  using enum oracle::Comparison;
  using enum oracle::Counter;
  record(context, "less/never_lowered", {less, never_decremented, {}});
  record(context, "less/lowered", {less, decremented, {}});
  record(context, "less_or_equal/never_lowered", {less_or_equal, never_decremented, {}});
  record(context, "less_or_equal/lowered", {less_or_equal, decremented, {}});

  for (int limit = 1; limit <= 6; ++limit) {
    const ComponentGraph graph = published_example(limit, loop_of_D);
    const InstanceTree tree = make_instance_tree(graph);
    context.record(fmt::format("engine/limit-{}/D", limit), instances_of(graph, tree, "D"));
  }
}

}  // namespace

extern const ExperimentDescriptor recursion_algorithm;
constinit const ExperimentDescriptor recursion_algorithm{
    .id = "lintermann1997/recursion-algorithm",
    .question = "Does the printed algorithm make the nine instances of its example?",
    .source = "[Lintermann1997] sec. 3.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
