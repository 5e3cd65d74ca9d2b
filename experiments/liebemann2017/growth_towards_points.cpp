// SPDX-License-Identifier: MIT
// Sec. 3.3 with so few influence points that the tree can be told beforehand.
#include <cmath>

#include "core/geometry/vector3.hpp"
#include "core/tree/branches.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr double far = 1e6;  // out of every node's reach

Seedling straight_ahead(double distance, Boundary boundary, int iterations = most_iterations) {
  Seedling seedling = scene({{0, distance, 0}}, {}, iterations);
  seedling.growth.variant.influence_boundary = boundary;
  seedling.growth.variant.kill_boundary = boundary;
  return seedling;
}

void measure_one_point(ExperimentContext& context) {
  std::int64_t different = 0, not_in_line = 0;
  for (const auto& [boundary, boundary_name] :
       {std::pair{Boundary::inclusive, "inclusive"}, std::pair{Boundary::exclusive, "exclusive"}}) {
    for (const int distance : {10, 20, 21, 34, 35, 36, 80, 95, 99, 100, 101}) {
      const Seedling seedling = straight_ahead(distance, boundary);
      const GrowthResult result = grow(seedling);
      const std::string name = fmt::format("one-point/{}/L-{}/", boundary_name, distance);
      context.record(name + "nodes_added", nodes_of(result) - 1);
      context.record(name + "stop", stop_of(result));
      different += differs_from_oracle(seedling, result);
      for (std::int32_t v = 1; v < static_cast<std::int32_t>(result.skeleton.node_count()); ++v)
        not_in_line += result.skeleton.position(v) != Vector3{0, v * step_length, 0};
    }
  }
  context.record("one-point/differs_from_oracle", different);
  context.record("one-point/nodes_not_in_line", not_in_line);
}

/// Each of the three reasons, and that the limit is one of iterations.
void measure_reasons(ExperimentContext& context) {
  const auto record = [&](const char* name, const GrowthResult& result) {
    context.record(fmt::format("reasons/{}/stop", name), stop_of(result));
    context.record(fmt::format("reasons/{}/iterations", name), iterations_that_grew(result));
    context.record(fmt::format("reasons/{}/points_left", name),
                   static_cast<std::int64_t>(result.live_points));
  };
  record("removed", grow(straight_ahead(95, Boundary::inclusive)));
  record("out_of_reach", grow(straight_ahead(101, Boundary::inclusive)));
  record("limit", grow(straight_ahead(95, Boundary::inclusive, 3)));
  // The near point goes, the far one stays: growth ends between them.
  record("one_of_two", grow(scene({{0, 50, 0}, {0, far, 0}}, {})));
}

/// Degrees between +x and the way to the first new node.
double first_direction_deg(const std::vector<Vector3>& points) {
  const Vector3 way = grow(scene(points, {}, 1)).skeleton.position(1);
  return std::atan2(way.y, way.x) * 180.0 / std::numbers::pi;
}

/// Every point counts the same however far it is; those out of reach do not count.
void measure_influence(ExperimentContext& context) {
  context.record("influence/equal_distances", first_direction_deg({{40, 0, 0}, {0, 40, 0}}), "deg");
  context.record("influence/other_distances", first_direction_deg({{30, 0, 0}, {0, 90, 0}}), "deg");
  context.record("influence/two_against_one",
                 first_direction_deg({{30, 0, 0}, {60, 0, 0}, {0, 90, 0}}), "deg");
  context.record("influence/one_out_of_reach", first_direction_deg({{30, 0, 0}, {0, 101, 0}}),
                 "deg");
  context.record("influence/twice_the_same_point",
                 first_direction_deg({{30, 0, 0}, {30, 0, 0}, {0, 90, 0}}), "deg");
}

/// A point belongs to one node only, the nearest: two nodes within reach, both of whom see it.
void measure_one_owner(ExperimentContext& context) {
  Seedling seedling = scene({{0, 70, 0}}, {}, 1);
  const std::int32_t nearer = seedling.skeleton.append(0, {0, 15, 0});
  const GrowthResult result = grow(seedling);
  context.record("one-owner/new_nodes", nodes_of(result) - 2);
  context.record("one-owner/predecessor_is_nearest",
                 std::int64_t{result.skeleton.parents()[2] == nearer});
}

/// A fork: the first successor takes the upper point over, and the others draw the root elsewhere.
void measure_fork(ExperimentContext& context) {
  const Seedling seedling = without_repeats(scene({{0, 60, 0}, {60, -2, 0}, {-60, -2, 0}}, {}));
  const GrowthResult result = grow(seedling);
  const ChildLists children(result.skeleton);
  context.record("fork/successors_of_root", static_cast<std::int64_t>(children.of(0).size()));
  context.record("fork/differs_from_oracle", differs_from_oracle(seedling, result));
}

/// Without points in S(v) nothing grows, and a point at the node itself is 0/0 in eq. 3.3.
void measure_empty_cases(ExperimentContext& context) {
  context.record("empty/no_points/nodes", nodes_of(grow(scene({}, {}))));
  Seedling pulled = scene({{0, 101, 0}}, {});
  pulled.growth.tropism = {0, 1, 0};
  context.record("empty/tropism_alone/nodes", nodes_of(grow(pulled)));
  context.record("empty/point_at_the_node/nodes", nodes_of(grow(scene({{0, 0, 0}}, {}))));
  const auto literal = oracles::liebemann2017::colonize(literal_scene(scene({{0, 0, 0}}, {})));
  context.record("empty/point_at_the_node/printed_is_undefined",
                 std::int64_t{literal.stop == oracles::liebemann2017::Stop::undefined});
}

void run(ExperimentContext& context) {
  measure_one_point(context);
  measure_reasons(context);
  measure_influence(context);
  measure_one_owner(context);
  measure_fork(context);
  measure_empty_cases(context);
}

}  // namespace

extern const ExperimentDescriptor growth_towards_points;
constinit const ExperimentDescriptor growth_towards_points{
    .id = "liebemann2017/growth-towards-points",
    .question = "How does a tree grow towards one, two and three influence points?",
    .source = "[Liebemann2017] sec. 3.2, 3.3, eq. 3.1-3.3",
    .seconds = {0.05, 0.05, 0.05},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
