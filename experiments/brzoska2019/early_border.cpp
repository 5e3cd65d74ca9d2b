// SPDX-License-Identifier: MIT
// Trees that reach the border of their cloud before their iterations are over. The cloud is a
// sphere of radius 5, a scene of ours; one of twice the radius stands beside it.
#include <fmt/format.h>

#include "core/tree/habit.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

TreeParameters sparse_then_dense(double cloud_radius, int iterations) {
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.2);
  TreeParameters parameters;
  parameters.cloud.radii = {cloud_radius, cloud_radius, cloud_radius};
  parameters.cloud_density = coupling.cloud_density;
  parameters.influence_distance = coupling.influence_distance;
  parameters.kill_distance.begin = coupling.kill_distance(0.0);
  parameters.kill_distance.end = coupling.kill_distance(0.8);
  parameters.iterations = iterations;
  return parameters;
}

/// One value per tree of everything that is looked at.
struct Crowns {
  ByTree branchings;
  ByTree points_left;  ///< share, before the iteration from which on the kill distance is small
  ByTree late_nodes;   ///< share of the nodes that the last third of the iterations adds
  ByTree late_outwardness;  ///< of the nodes that the last quarter of those executed adds
};

/// Mean cosine between the edges of the nodes from `first` on and the direction away from the crown
/// root: 1 if they lead straight away from it, 0 if they go around it.
double outwardness(const Skeleton& tree, std::size_t first, const Vector3& crown_root) {
  double sum = 0.0;
  for (std::size_t i = first; i < tree.node_count(); ++i) {
    const Vector3 lower = tree.position(tree.parents()[i]);
    const Vector3 edge = tree.positions()[i] - lower, outwards = tree.positions()[i] - crown_root;
    sum += dot(edge, outwards) / (norm(edge) * norm(outwards));
  }
  return first < tree.node_count() ? sum / static_cast<double>(tree.node_count() - first) : 0.0;
}

/// Nodes added in iterations from `first` on.
std::size_t nodes_since(const GrowthResult& result, int first) {
  std::size_t nodes = 0;
  for (const PassStatistics& pass : result.passes)
    if (pass.iteration >= first) nodes += pass.new_nodes;
  return nodes;
}

/// Share of the points that live before an iteration; of the last one if growth stopped earlier.
double share_left_at(const GrowthResult& result, int iteration, std::size_t points) {
  std::size_t left = result.live_points;
  for (const PassStatistics& pass : result.passes)
    if (pass.iteration == iteration) left = pass.live_points;
  return static_cast<double>(left) / static_cast<double>(points);
}

void watch(const TreeParameters& parameters, const ExperimentContext& context, Crowns& crowns) {
  const Seedling seedling = make_seedling(parameters);
  const GrowthResult result = grow_seedling(seedling, context);
  const int iterations = parameters.iterations;
  const auto crown_nodes =
      static_cast<double>(result.skeleton.node_count() - seedling.skeleton.node_count());
  crowns.branchings.push_back(static_cast<double>(branching_count(result.skeleton)));
  // The argument of the sigmoid runs from -12 to 6: it passes 0 after two thirds.
  crowns.points_left.push_back(
      share_left_at(result, 2 * iterations / 3, seedling.attraction_points.size()));
  crowns.late_nodes.push_back(static_cast<double>(nodes_since(result, 2 * iterations / 3)) /
                              crown_nodes);
  const auto executed = static_cast<int>(result.passes.size());
  crowns.late_outwardness.push_back(outwardness(
      result.skeleton, result.skeleton.node_count() - nodes_since(result, 3 * executed / 4),
      seedling.skeleton.position(seedling.crown_root)));
}

Crowns record_crowns(ExperimentContext& context, double cloud_radius, int iterations) {
  const std::string name = fmt::format("radius-{:.0f}/{}-iterations", cloud_radius, iterations);
  const TreeParameters parameters = sparse_then_dense(cloud_radius, iterations);
  Crowns crowns;
  record_trees(context, name + "/branchings", "branchings", [&](std::size_t number) {
    watch(tree_of_trend(parameters, context, number), context, crowns);
    return crowns.branchings.back();
  });
  const auto record = [&](const char* what, const ByTree& values) {
    record_trees(context, name + what, "1", [&](std::size_t number) { return values[number]; });
  };
  record("/points-left-when-density-rises", crowns.points_left);
  record("/share-of-nodes-in-last-third", crowns.late_nodes);
  record("/outwardness-in-last-quarter", crowns.late_outwardness);
  return crowns;
}

void run(ExperimentContext& context) {
  const Crowns short_run = record_crowns(context, 5.0, 40);
  const Crowns long_run = record_crowns(context, 5.0, 80);
  const Crowns short_run_with_room = record_crowns(context, 10.0, 40);
  const Crowns long_run_with_room = record_crowns(context, 10.0, 80);
  record_trend(context, "fewer-branchings-when-older", short_run.branchings, long_run.branchings);
  record_trend(context, "fewer-points-when-density-rises", short_run.points_left,
               long_run.points_left);
  record_trend(context, "fewer-late-nodes-when-older", short_run.late_nodes, long_run.late_nodes);
  record_trend(context, "around-the-border/40-iterations", short_run_with_room.late_outwardness,
               short_run.late_outwardness);
  record_trend(context, "around-the-border/80-iterations", long_run_with_room.late_outwardness,
               long_run.late_outwardness);
}

}  // namespace

extern const ExperimentDescriptor early_border;
constinit const ExperimentDescriptor early_border{
    .id = "brzoska2019/early-border",
    .question = "What grows once a tree has reached the border of its cloud?",
    .source = "[Brzoska2019] sec. 6.2, fig. 49",
    .seconds = {1.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
