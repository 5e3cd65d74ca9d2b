// SPDX-License-Identifier: MIT
// Eq. 3.5: branch depths of trees that the turtle draws, and of a few small ones, as they are when
// a node is made and as the finished tree would have them.
#include <map>

#include "experiments/liebemann2017/literal_branch_depths.hpp"
#include "experiments/liebemann2017/turtle_graphs.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

using enum BranchDepthReading;

void record_histogram(ExperimentContext& context, const std::string& name,
                      const std::map<std::int32_t, std::int64_t>& nodes) {
  for (const auto& [Z, count] : nodes) context.record(fmt::format("{}/Z-{}", name, Z), count);
}

void measure_figures(ExperimentContext& context) {
  for (const auto& [name, graph] : graphs_of_the_figures()) {
    const Skeleton& skeleton = graph.skeleton;
    const ChildLists successors(skeleton);
    context.record(name + "/differs_from_oracle", other_branch_depths(skeleton));
    for (const auto& [reading, reading_name] :
         {std::pair{at_creation, "at_creation"}, std::pair{finished_tree, "finished"}}) {
      const std::vector<std::int32_t> depths = branch_depths(skeleton, reading);
      context.record(fmt::format("{}/{}/greatest_Z", name, reading_name),
                     std::int64_t{*std::max_element(depths.begin(), depths.end())});
      if (name != "space-tree") continue;
      std::map<std::int32_t, std::int64_t> nodes, tips;
      for (std::size_t v = 0; v < depths.size(); ++v) {
        ++nodes[depths[v]];
        if (successors.of(static_cast<std::int32_t>(v)).empty()) ++tips[depths[v]];
      }
      record_histogram(context, fmt::format("space-tree/{}/nodes", reading_name), nodes);
      record_histogram(context, fmt::format("space-tree/{}/tips", reading_name), tips);
    }
  }
}

/// A root with one successor, which has two; the second of these has two as well.
void measure_small_tree(ExperimentContext& context) {
  Skeleton tree{Vector3{}};
  for (const std::int32_t parent : {0, 1, 1, 3, 3})
    tree.append(parent, tree.position(parent) + Vector3{static_cast<double>(parent), 1, 0});
  const std::vector<std::int32_t> depths = branch_depths(tree, at_creation);
  for (std::size_t v = 0; v < depths.size(); ++v)
    context.record(fmt::format("small-tree/Z_of_node-{}", v), std::int64_t{depths[v]});
}

/// A side branch in brackets, written before the axis goes on: who is deeper?
void measure_bracketed_branch(ExperimentContext& context) {
  const Graph graph = graph_of("F(1)[+(90)F(1)]F(1)");
  const std::vector<std::int32_t> depths = depths_at_creation(graph.skeleton);
  context.record("bracketed-branch/Z_of_the_branch", std::int64_t{depths.at(2)});
  context.record("bracketed-branch/Z_of_the_axis", std::int64_t{depths.at(3)});
}

/// A branch that turns by 30 degrees at every node.
void measure_bent_branch(ExperimentContext& context) {
  Skeleton branch{Vector3{}};
  for (std::int32_t v = 0; v < 12; ++v) {
    const double heading = v * std::numbers::pi / 6.0;
    branch.append(v, branch.position(v) + Vector3{std::sin(heading), std::cos(heading), 0});
  }
  context.record("bent-branch/greatest_Z", greatest_Z(branch));
  const std::vector<std::int32_t> depths = node_depths(branch);
  context.record("bent-branch/greatest_depth",
                 std::int64_t{*std::max_element(depths.begin(), depths.end())});
}

void run(ExperimentContext& context) {
  measure_figures(context);
  measure_small_tree(context);
  measure_bracketed_branch(context);
  measure_bent_branch(context);
}

}  // namespace

extern const ExperimentDescriptor branch_depths_of_drawings;
constinit const ExperimentDescriptor branch_depths_of_drawings{
    .id = "liebemann2017/branch-depths-of-drawings",
    .question = "Which branch depths do the trees of chapter 2 have?",
    .source = "[Liebemann2017] sec. 3.5, eq. 3.5",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
