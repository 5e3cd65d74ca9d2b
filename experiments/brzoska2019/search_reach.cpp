// SPDX-License-Identifier: MIT
// What a large influence distance does to the optimised search: nodes that the voxel grid compares
// with each point, and points that the box of all nodes leaves out. The tree and its cloud are
// always those of Table 1, fully grown.
#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// The crown's nodes, each looking along the edge below it.
std::vector<SearchableNode> crown_nodes(const Skeleton& tree, std::int32_t crown_root) {
  std::vector<SearchableNode> nodes;
  for (auto i = static_cast<std::size_t>(crown_root); i < tree.node_count(); ++i) {
    const Vector3 edge = tree.positions()[i] - tree.position(tree.parents()[i]);
    nodes.push_back({tree.positions()[i], edge / norm(edge)});
  }
  return nodes;
}

WorkCounters work_of_search(std::span<const Vector3> points, std::span<const SearchableNode> nodes,
                            double influence_distance) {
  const auto engine = engine_named("voxel_grid").create();
  engine->reset(points, {.influence_distance = influence_distance,
                         .perception_half_angle_rad = std::numbers::pi});
  engine->associate(nodes);
  return engine->counters();
}

/// Share of the points beyond the box of all nodes, widened by the influence distance.
double left_out_by_box(std::span<const Vector3> points, std::span<const SearchableNode> nodes,
                       double influence_distance) {
  BoundingBox box;
  for (const SearchableNode& node : nodes) box.extend(node.position);
  const BoundingBox reach = box.widened(influence_distance);
  const auto inside = std::count_if(points.begin(), points.end(),
                                    [&](const Vector3& point) { return reach.contains(point); });
  return 1.0 - static_cast<double>(inside) / static_cast<double>(points.size());
}

void run(ExperimentContext& context) {
  context.progress("growing the test tree");
  const Seedling seedling = make_seedling(thesis_tree("figure-51"));
  const Skeleton tree = grow_seedling(seedling, context).skeleton;
  const std::vector<SearchableNode> nodes = crown_nodes(tree, seedling.crown_root);
  const std::vector<Vector3>& points = seedling.attraction_points;
  context.record("nodes", static_cast<std::int64_t>(nodes.size()));
  context.record("points", static_cast<std::int64_t>(points.size()));
  for (const double distance : {0.5, 0.7, 1.0, 1.4, 2.0, 4.0, 8.0}) {
    context.progress(fmt::format("searching within {}", distance));
    const std::string name = fmt::format("influence-{:.1f}", distance);
    const WorkCounters work = work_of_search(points, nodes, distance);
    const double per_point =
        static_cast<double>(work.search_evaluations) / static_cast<double>(work.queries);
    context.record(name + "/influence-distance", distance, "length");
    context.record(name + "/nodes-per-point", per_point, "nodes");
    context.record(name + "/share-of-all-nodes", per_point / static_cast<double>(nodes.size()));
    context.record(name + "/points-left-out-by-the-box", left_out_by_box(points, nodes, distance));
  }
}

}  // namespace

extern const ExperimentDescriptor search_reach;
constinit const ExperimentDescriptor search_reach{
    .id = "brzoska2019/search-reach",
    .question = "How much of the optimised search is left when the influence distance is large?",
    .source = "[Brzoska2019] sec. 4.1, 5.2.2",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
