// SPDX-License-Identifier: MIT
// Sec. 4.1: functions that call themselves for the successors of a node, on the suite's trees.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/tree/branch_depth.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/turtle_graphs.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

/// What recursion over the lists of successors finds at each node.
struct Recursion {
  ChildLists successors;
  std::vector<std::int32_t> tips, depths;
  std::vector<double> radii;  // eq. 3.4 with r_0 = 1 and g = 2
  std::int64_t visited = 0;

  explicit Recursion(const Skeleton& skeleton)
      : successors(skeleton),
        tips(skeleton.node_count(), 0),
        depths(skeleton.node_count(), 0),
        radii(skeleton.node_count(), 1.0) {
    visit(0, 0);
  }

  void visit(std::int32_t node, std::int32_t depth) {
    const auto v = static_cast<std::size_t>(node);
    ++visited;
    depths[v] = depth;
    if (successors.of(node).empty()) {
      tips[v] = 1;
      return;
    }
    double sum = 0.0;
    for (const std::int32_t successor : successors.of(node)) {
      visit(successor, depth + 1);
      const auto n = static_cast<std::size_t>(successor);
      tips[v] += tips[n];
      sum += radii[n] * radii[n];
    }
    radii[v] = std::sqrt(sum);
  }
};

std::int64_t different(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

/// Start of each edge as its predecessor's end, against the line that the turtle drew.
double starts_off(const Graph& graph) {
  const Drawing drawing = draw(graph.system, graph.word);
  double off = 0.0;
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    const Vector3& start = graph.skeleton.position(graph.skeleton.parents()[i + 1]);
    off = std::max(off, largest_entry(start - drawing.segments[i].from));
  }
  return off;
}

void measure(ExperimentContext& context, const std::string& name, const Graph& graph) {
  const Skeleton& skeleton = graph.skeleton;
  const Recursion recursion(skeleton);
  const std::vector<double> radii = branch_radii(skeleton, 1.0, 2.0);
  double radii_off = 0.0;
  for (std::size_t v = 0; v < radii.size(); ++v)
    radii_off = std::max(radii_off, std::abs(recursion.radii[v] / radii[v] - 1.0));
  const std::vector<std::int32_t> branch_depth =
      branch_depths(skeleton, BranchDepthReading::at_creation);
  context.record(name + "/visited", recursion.visited, "nodes");
  context.record(name + "/nodes", static_cast<std::int64_t>(skeleton.node_count()), "nodes");
  context.record(name + "/other_tips", different(recursion.tips, tips_above(skeleton)), "nodes");
  context.record(name + "/other_depths", different(recursion.depths, node_depths(skeleton)),
                 "nodes");
  context.record(name + "/radii_off", radii_off);
  context.record(name + "/other_branch_depths_than_oracle",
                 different(branch_depth, literal::branch_depths_at_creation(literal_graph(graph))),
                 "nodes");
  context.record(name + "/deepest_branch",
                 std::int64_t{*std::max_element(branch_depth.begin(), branch_depth.end())});
  context.record(name + "/starts_off", starts_off(graph), "length");
}

void run(ExperimentContext& context) {
  for (const auto& [name, graph] : graphs_of_the_figures()) measure(context, name, graph);
}

}  // namespace

extern const ExperimentDescriptor recursive_functions;
constinit const ExperimentDescriptor recursive_functions{
    .id = "liebemann2017/recursive-functions",
    .question = "Can tips, depths and radii be found by recursion over the successors?",
    .source = "[Liebemann2017] sec. 4.1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
