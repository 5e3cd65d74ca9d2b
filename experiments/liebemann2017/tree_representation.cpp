// SPDX-License-Identifier: MIT
// Sec. 4.1: one graph for what the turtle draws and for what space colonization grows.
#include <numbers>
#include <string>
#include <vector>

#include "core/colonization/attraction_region.hpp"
#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branch_depth.hpp"
#include "core/tree/branch_mesh.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/turtle_graphs.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// A disc of 500 points with the distances of figure 3.2.
Skeleton grown_tree(std::uint64_t seed) {
  const auto stream = make_stream(StreamKind::counter, seed, 11);
  RoundRegion region;
  region.radius = 250.0;
  Seedling seedling;
  seedling.attraction_points = attraction_points(region, 500, *stream);
  seedling.skeleton = Skeleton(Vector3{0, -250, 0});
  seedling.growth.iterations = 60;
  seedling.growth.step_length = 15.0;
  seedling.growth.influence_distance = 100.0;
  seedling.growth.perception_angle_rad = 2.0 * std::numbers::pi;
  seedling.growth.kill_distance.begin = 20.0;
  seedling.growth.kill_distance.end = 20.0;
  const auto engine = engine_named("squared_scan").create();
  return grow_crown(seedling, *engine).skeleton;
}

/// Nodes whose predecessor is not found again among the lists of successors, and nodes that these
/// lists do not lead to from the root.
std::int64_t not_in_the_lists(const Skeleton& skeleton) {
  const ChildLists successors(skeleton);
  std::vector<std::int32_t> found(skeleton.node_count(), -2), open = {0};
  found[0] = Skeleton::no_parent;
  while (!open.empty()) {
    const std::int32_t v = open.back();
    open.pop_back();
    for (const std::int32_t n : successors.of(v)) {
      found[static_cast<std::size_t>(n)] = v;
      open.push_back(n);
    }
  }
  std::int64_t other = 0;
  for (std::size_t v = 0; v < found.size(); ++v) other += found[v] != skeleton.parents()[v];
  return other;
}

/// Entries of all lists of successors.
std::int64_t entries_of_the_lists(const Skeleton& skeleton) {
  const ChildLists successors(skeleton);
  std::size_t entries = 0;
  for (std::size_t v = 0; v < skeleton.node_count(); ++v)
    entries += successors.of(static_cast<std::int32_t>(v)).size();
  return static_cast<std::int64_t>(entries);
}

/// Nodes whose branch depth, stored when they were made, is not what eq. 3.5 gives literally.
std::int64_t other_branch_depths(const Skeleton& skeleton) {
  BranchDepths stored;
  for (const std::int32_t parent : skeleton.parents()) stored.append(parent);
  const auto& parents = skeleton.parents();
  const std::vector<int> expected = oracles::liebemann2017::branch_depths_at_creation(
      oracles::liebemann2017::TreeGraph(std::vector<int>(parents.begin(), parents.end())));
  std::int64_t other = 0;
  for (std::size_t v = 0; v < expected.size(); ++v) other += stored.depths()[v] != expected[v];
  return other;
}

void measure(ExperimentContext& context, const std::string& name, const Skeleton& skeleton) {
  constexpr int corners = 6;
  BranchMeshOptions options;
  options.circle_resolution = corners;
  const BranchMesh mesh = mesh_branches(skeleton, branch_radii(skeleton, 1.0, 2.0), options);
  record_seeded(context, name + "/nodes", static_cast<std::int64_t>(skeleton.node_count()));
  record_seeded(context, name + "/edges", entries_of_the_lists(skeleton));
  record_seeded(context, name + "/not_in_the_lists", not_in_the_lists(skeleton));
  record_seeded(context, name + "/other_branch_depths", other_branch_depths(skeleton));
  record_seeded(context, name + "/triangles_by_corners",
                static_cast<std::int64_t>(mesh.mesh.triangle_count()) / (2 * corners));
  record_seeded(context, name + "/triangles_left_over",
                static_cast<std::int64_t>(mesh.mesh.triangle_count()) % (2 * corners));
}

void run(ExperimentContext& context) {
  measure(context, "turtle", graph_of(space_tree_system(pitch_a_deg), 6).skeleton);
  measure(context, "space-colonization", grown_tree(context.seed()));
}

}  // namespace

extern const ExperimentDescriptor tree_representation;
constinit const ExperimentDescriptor tree_representation{
    .id = "liebemann2017/tree-representation",
    .question = "Does one graph serve both the turtle and space colonization?",
    .source = "[Liebemann2017] sec. 4.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
