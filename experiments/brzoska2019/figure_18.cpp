// SPDX-License-Identifier: MIT
// One step of space colonization as figure 18 shows it: six nodes and four points; an axis that
// goes on, a branch to the left, and the two points on the left gone. The figure prints no
// coordinates; these are ours.
#include <numbers>

#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/observed_growth.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// An upright row of nodes, two points to the left of its middle, two ahead of its end.
Seedling figure() {
  Seedling seedling;
  for (std::int32_t i = 0; i < 5; ++i) seedling.skeleton.append(i, {0, i + 1.0, 0});
  seedling.attraction_points = {{-1.5, 3.2, 0}, {-1.4, 3.4, 0}, {0.2, 7.3, 0}, {0.6, 7.2, 0}};
  seedling.growth = {.iterations = 1,
                     .step_length = 1.0,
                     .influence_distance = 2.6,
                     .perception_angle_rad = 2.0 * std::numbers::pi,
                     .kill_distance = {.begin = 0.8, .end = 0.8},
                     .tropism = {},
                     .variant = {}};
  return seedling;
}

std::int64_t whole(bool value) {
  return value ? 1 : 0;
}

void run(ExperimentContext& context) {
  const Seedling before = figure();
  ObservedEngine engine(engine_named("euclidean_scan"));
  std::string order;
  engine.associated = [&](const Assignment&) { order += "link"; };
  std::size_t killers = 0;
  engine.killed = [&](std::span<const SearchableNode> nodes, double) {
    order += " remove";
    killers = nodes.size();
  };
  const Skeleton after = grow_crown(before, engine, {}).skeleton;
  const std::size_t old_nodes = before.skeleton.node_count();
  context.record("nodes-before", static_cast<std::int64_t>(old_nodes), "nodes");
  context.record("points-before", static_cast<std::int64_t>(before.attraction_points.size()),
                 "points");
  context.record("new-nodes", static_cast<std::int64_t>(after.node_count() - old_nodes), "nodes");
  std::int64_t on_the_axis = 0, to_the_left = 0;
  const auto end = static_cast<std::int32_t>(old_nodes) - 1;
  for (std::size_t i = old_nodes; i < after.node_count(); ++i) {
    const bool from_the_end = after.parents()[i] == end;
    on_the_axis += from_the_end && after.positions()[i].y > after.position(end).y;
    to_the_left += !from_the_end && after.positions()[i].x < 0.0;
  }
  context.record("nodes-on-the-axis", on_the_axis, "nodes");
  context.record("branches-to-the-left", to_the_left, "nodes");
  context.record("points-left", static_cast<std::int64_t>(engine.live_points()), "points");
  context.record("left-points-removed", whole(!engine.alive[0] && !engine.alive[1]));
  context.record("order", order);
  context.record("new-nodes-may-remove", whole(killers >= after.node_count() - old_nodes));
}

}  // namespace

extern const ExperimentDescriptor figure_18;
constinit const ExperimentDescriptor figure_18{
    .id = "brzoska2019/figure-18",
    .question = "Does one step of growth do what the thesis' example shows?",
    .source = "[Brzoska2019] sec. 3.4.4, fig. 18",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
