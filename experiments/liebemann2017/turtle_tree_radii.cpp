// SPDX-License-Identifier: MIT
// Eq. 3.4 on the trees that the turtle leaves behind.
#include <cmath>

#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/turtle_graphs.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

/// Greatest relative error of eq. 3.4 at a node, and how many are thinner than one above them.
void measure_radii(ExperimentContext& context, const std::string& name, const Graph& graph) {
  const ChildLists children(graph.skeleton);
  const literal::TreeGraph G = literal_graph(graph);
  double unfulfilled = 0.0, oracle_off = 0.0;
  std::int64_t thinner = 0, other_tips = 0;
  for (const double g : {2.0, 2.5, 3.0}) {
    const std::vector<double> radii = branch_radii(graph.skeleton, 1.0, g),
                              expected = literal::radii(G, 1.0, g);
    for (std::size_t v = 0; v < radii.size(); ++v) {
      oracle_off = std::max(oracle_off, std::abs(radii[v] / expected[v] - 1.0));
      const auto successors = children.of(static_cast<std::int32_t>(v));
      other_tips += successors.empty() && radii[v] != 1.0;
      if (successors.empty()) continue;
      double sum = 0.0;
      for (const std::int32_t n : successors) {
        sum += std::pow(radii[static_cast<std::size_t>(n)], g);
        thinner += radii[v] < radii[static_cast<std::size_t>(n)];
      }
      unfulfilled = std::max(unfulfilled, std::abs(sum / std::pow(radii[v], g) - 1.0));
    }
    context.record(fmt::format("{}root_radius/g-{}", name, g), radii[0], "length");
  }
  context.record(name + "root_radius/tips_of_half_the_radius",
                 branch_radii(graph.skeleton, 0.5, 2.0)[0], "length");
  context.record(name + "eq_3_4_unfulfilled", unfulfilled);
  context.record(name + "radii_off_oracle", oracle_off);
  context.record(name + "thinner_than_a_successor", thinner);
  context.record(name + "tips_of_other_radius", other_tips);
}

void run(ExperimentContext& context) {
  for (const auto& [name, graph] : graphs_of_the_figures())
    measure_radii(context, name + "/", graph);
}

}  // namespace

extern const ExperimentDescriptor turtle_tree_radii;
constinit const ExperimentDescriptor turtle_tree_radii{
    .id = "liebemann2017/turtle-tree-radii",
    .question = "How thick does eq. 3.4 make the branches that the turtle draws?",
    .source = "[Liebemann2017] sec. 3.4, eq. 3.4",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
