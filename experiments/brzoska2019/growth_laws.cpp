// SPDX-License-Identifier: MIT
// Laws that every grown tree must keep, checked on the thesis' test tree and on small fixtures.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/observed_growth.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

std::int64_t count(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

double angle_deg(const Vector3& a, const Vector3& b) {
  return degrees(std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0)));
}

GrowthResult grow_quickly(const Seedling& seedling, const GrowthRun& run = {}) {
  const auto engine = engine_named("voxel_grid").create();
  return grow_crown(seedling, *engine, run);
}

/// What is counted while the test tree grows.
struct AssociationLaws {
  std::size_t beyond_influence = 0;
  std::size_t beyond_angle = 0;
  std::size_t nonempty_sets = 0;
  std::size_t survivors = 0;
  std::size_t lost_by_box = 0;
  std::size_t box_differences = 0;
};

void check_association(const Seedling& seedling, const ObservedEngine& engine,
                       BoundingBox& running_box, std::size_t& boxed, const Assignment& assignment,
                       AssociationLaws& laws) {
  const GrowthParameters& growth = seedling.growth;
  BoundingBox fresh_box;
  for (const SearchableNode& node : engine.nodes) fresh_box.extend(node.position);
  for (; boxed < engine.nodes.size(); ++boxed) running_box.extend(engine.nodes[boxed].position);
  laws.box_differences +=
      !(fresh_box.low() == running_box.low() && fresh_box.high() == running_box.high());
  const BoundingBox reach = running_box.widened(growth.influence_distance);
  std::set<NodeIndex> sets;
  for (std::size_t i = 0; i < assignment.node.size(); ++i) {
    if (assignment.node[i] == no_node) continue;
    const Vector3& point = seedling.attraction_points[i];
    const SearchableNode& node = engine.nodes[static_cast<std::size_t>(assignment.node[i])];
    sets.insert(assignment.node[i]);
    laws.beyond_influence += norm(point - node.position) > growth.influence_distance * (1 + 1e-12);
    laws.beyond_angle += angle_deg(node.direction, point - node.position) >
                         degrees(0.5 * growth.perception_angle_rad) + 1e-6;
    laws.lost_by_box += !reach.contains(point);
  }
  laws.nonempty_sets += sets.size();
}

void check_removal(const Seedling& seedling, const ObservedEngine& engine,
                   std::span<const SearchableNode> killers, double distance,
                   AssociationLaws& laws) {
  for (std::size_t i = 0; i < engine.alive.size(); ++i) {
    if (!engine.alive[i]) continue;
    for (const SearchableNode& killer : killers)
      laws.survivors +=
          squared_distance(seedling.attraction_points[i], killer.position) <= distance * distance;
  }
}

/// At the end no live point may be within the last, smallest kill distance of any node that removes
/// points.
std::size_t survivors_at_the_end(const Seedling& seedling, const ObservedEngine& engine) {
  const KillDistanceSchedule& kill = seedling.growth.kill_distance;
  const double distance = kill.at(seedling.growth.iterations - 1, seedling.growth.iterations);
  std::size_t survivors = 0;
  for (std::size_t i = 0; i < engine.alive.size(); ++i) {
    if (!engine.alive[i]) continue;
    for (const SearchableNode& node : engine.nodes)
      survivors +=
          squared_distance(seedling.attraction_points[i], node.position) <= distance * distance;
  }
  return survivors;
}

void record_test_tree(ExperimentContext& context) {
  context.progress("watching the test tree grow");
  const TreeParameters parameters = thesis_tree("figure-51");
  const Seedling seedling = make_seedling(parameters);
  ObservedEngine engine(engine_named("voxel_grid"));
  AssociationLaws laws;
  BoundingBox running_box;
  std::size_t boxed = 0;
  engine.associated = [&](const Assignment& assignment) {
    check_association(seedling, engine, running_box, boxed, assignment, laws);
  };
  engine.killed = [&](std::span<const SearchableNode> killers, double distance) {
    check_removal(seedling, engine, killers, distance, laws);
  };
  std::size_t children = 0, calls = 0;
  const GrowthResult result =
      grow_crown(seedling, engine, {.observer = [&](const PassStatistics& pass) {
                   children += pass.new_nodes + pass.suppressed_repeats;
                   ++calls;
                   return true;
                 }});
  context.record("association/beyond_influence", count(laws.beyond_influence));
  context.record("association/beyond_angle", count(laws.beyond_angle));
  context.record("sets/unexplained_nodes", count(laws.nonempty_sets) - count(children));
  context.record("kill/survivors_within_reach",
                 count(laws.survivors + survivors_at_the_end(seedling, engine)));
  context.record("box/lost_links", count(laws.lost_by_box));
  context.record("box/update_differences", count(laws.box_differences));
  context.record("callbacks/calls", count(calls));
  context.record("callbacks/iterations", count(result.passes.size()));

  // Steps and paths.
  const Skeleton& tree = result.skeleton;
  const double step = seedling.growth.step_length;
  double step_error = 0.0, highest = tree.positions().front().y;
  std::vector<double> path(tree.node_count(), 0.0);
  for (std::size_t i = 1; i < tree.node_count(); ++i) {
    const double edge = norm(tree.positions()[i] - tree.position(tree.parents()[i]));
    path[i] = path[static_cast<std::size_t>(tree.parents()[i])] + edge;
    highest = std::max(highest, tree.positions()[i].y);
    if (i > static_cast<std::size_t>(seedling.crown_root))
      step_error = std::max(step_error, std::abs(edge - step) / step);
  }
  context.record("step/max_relative_error", step_error);
  context.record("path_length/longest", *std::max_element(path.begin(), path.end()));
  context.record("path_length/bound",
                 parameters.stem_length + static_cast<double>(result.passes.size()) * step);
  context.record("tree_height/error", std::abs(highest_y(tree) - highest));

  // The box of the crown root alone holds no point: without the margin growth could not begin.
  BoundingBox root_box;
  root_box.extend(tree.position(seedling.crown_root));
  context.record("box/points_without_margin",
                 count(static_cast<std::size_t>(std::count_if(
                     seedling.attraction_points.begin(), seedling.attraction_points.end(),
                     [&](const Vector3& point) { return root_box.contains(point); }))));
}

Seedling fixture(std::vector<Vector3> points, int iterations, double influence, double kill,
                 double angle_deg_full) {
  Seedling seedling;
  seedling.attraction_points = std::move(points);
  seedling.growth = {.iterations = iterations,
                     .step_length = 0.25,
                     .influence_distance = influence,
                     .perception_angle_rad = angle_deg_full * std::numbers::pi / 180.0,
                     .kill_distance = {.begin = kill, .end = kill},
                     .tropism = {},
                     .variant = {}};
  return seedling;
}

void record_stops(ExperimentContext& context) {
  const auto stops = [](const Seedling& seedling, StopReason reason) {
    return std::int64_t{grow_quickly(seedling).stop_reason == reason};
  };
  context.record("stop/iteration_limit",
                 stops(fixture({{0, 3, 0}}, 2, 5.0, 0.1, 160), StopReason::iteration_limit));
  context.record("stop/no_point_in_range",
                 stops(fixture({{0, 10, 0}}, 9, 0.5, 0.3, 160), StopReason::no_point_in_range));
  context.record("stop/no_points_left",
                 stops(fixture({{0, 0.4, 0}}, 9, 0.5, 0.3, 160), StopReason::no_points_left));
  int calls = 0;
  grow_quickly(fixture({{0, 9, 0}}, 20, 50.0, 0.1, 160),
               {.observer = [&](const PassStatistics&) { return ++calls < 3; }});
  context.record("callbacks/after_stop", std::int64_t{calls - 3});
}

/// Figure 18 in our own coordinates: six nodes in a row, two points to the left, two above.
void record_example(ExperimentContext& context) {
  Seedling seedling =
      fixture({{-1.5, 3.2, 0}, {-1.4, 3.4, 0}, {0.8, 6.8, 0}, {1.2, 7.0, 0}}, 1, 2.6, 0.8, 360);
  seedling.growth.step_length = 1.0;
  for (std::int32_t i = 0; i < 5; ++i) seedling.skeleton.append(i, {0, i + 1.0, 0});
  const GrowthResult result = grow_quickly(seedling);
  context.record("example/nodes", count(result.skeleton.node_count()));
  context.record("example/live_points", count(result.live_points));
}

/// Two points that stay nearest to the origin whatever grows between them.
void record_repeat_guard(ExperimentContext& context) {
  for (const RepeatGuard guard : {RepeatGuard::on, RepeatGuard::off}) {
    Seedling seedling = fixture({{-0.4, 0.08, 0}, {0.4, 0.08, 0}}, 10, 0.5, 0.3, 160);
    seedling.growth.variant.repeat_guard = guard;
    const GrowthResult result = grow_quickly(seedling);
    const auto& parents = result.skeleton.parents();
    context.record(
        guard == RepeatGuard::on ? "repeat_guard/children_with" : "repeat_guard/children_without",
        count(static_cast<std::size_t>(std::count(parents.begin(), parents.end(), 0))));
  }
}

void record_determinism(ExperimentContext& context) {
  std::set<std::string> trees;
  for (const int threads : {1, 1, 2}) {
    const Seedling seedling = make_seedling(thesis_tree("figure-40"));
    trees.insert(tree_hash(grow_quickly(seedling, {.threads = threads}).skeleton));
  }
  context.record("determinism/distinct_trees", count(trees.size()));
}

void record_stems(ExperimentContext& context) {
  for (const char* length : {"0", "1", "1.2", "1.8", "2"}) {
    TreeParameters parameters;
    parameters.cloud_density = 1.0;
    parameters.stem_length = std::stod(length);
    context.record(fmt::format("stem/length-{}/edges", length),
                   count(make_seedling(parameters).skeleton.edge_count()));
  }
  TreeParameters parameters = thesis_tree("figure-40");
  const Seedling without = make_seedling(parameters);
  context.record("crown_stem/ratio-0/edges", count(start_nodes(without).size() - 1));
  parameters.crown_stem_ratio = 1.0;
  const Seedling with = make_seedling(parameters);
  double trunk = 0.0;
  for (std::size_t i = static_cast<std::size_t>(with.crown_root) + 1;
       i < with.skeleton.node_count(); ++i)
    trunk += norm(with.skeleton.positions()[i] - with.skeleton.positions()[i - 1]);
  context.record("crown_stem/ratio-1/height_share",
                 trunk / extent_of(with.attraction_points).extent().y);
}

/// Turning angles between an edge and its parent edge, without tropism.
void record_turning(ExperimentContext& context) {
  for (const double full_angle : {160.0, 360.0}) {
    TreeParameters parameters = thesis_tree("figure-40");
    parameters.tropism_direction = {};
    parameters.perception_angle_deg = full_angle;
    const Seedling seedling = make_seedling(parameters);
    const Skeleton tree = grow_quickly(seedling).skeleton;
    double largest = 0.0;
    std::size_t backward = 0;
    for (std::size_t i = static_cast<std::size_t>(seedling.crown_root) + 1; i < tree.node_count();
         ++i) {
      const auto parent = static_cast<std::size_t>(tree.parents()[i]);
      const double turn =
          angle_deg(tree.positions()[parent] - tree.position(tree.parents()[parent]),
                    tree.positions()[i] - tree.positions()[parent]);
      largest = std::max(largest, turn);
      backward += turn > 90.0;
    }
    if (full_angle == 160.0) context.record("perception/max_turn_deg", largest, "degree");
    context.record(fmt::format("perception/backward_edges_{:.0f}", full_angle), count(backward));
  }
}

void record_tropism_weights(ExperimentContext& context) {
  for (const char* figure : {"figure-51", "figure-40"})
    context.record(std::string("tropism_weight/") + figure,
                   make_seedling(thesis_tree(figure)).growth.tropism.y);
  context.record("tropism_weight/flat_cloud", tropism_damping_weight({2, 1, 2}));
  context.record("tropism_weight/tall_cloud", tropism_damping_weight({1, 2, 1}));
}

/// Voxels narrower than the influence distance lose a node; voxels as wide keep one exactly there.
void record_voxels(ExperimentContext& context) {
  const double edge = 1.0, influence = 1.5, point = 0.99, node = 2.01;
  const bool in_reach = node - point <= influence;
  const bool looked_into = std::abs(std::floor(node / edge) - std::floor(point / edge)) <= 1.0;
  context.record("voxel/smaller_edge_misses", std::int64_t{in_reach && !looked_into});

  std::int64_t found = 1;
  for (const Vector3& place :
       {Vector3{0.5, 0, 0}, Vector3{-0.5, 0, 0}, Vector3{0, -0.5, 0}, Vector3{0.3, 0.4, 0}}) {
    const std::vector<Vector3> points{place};
    const auto engine = engine_named("voxel_grid").create();
    engine->reset(points,
                  {.influence_distance = 0.5, .perception_half_angle_rad = std::numbers::pi});
    const SearchableNode origin{{0, 0, 0}, {0, 1, 0}};
    found &= engine->associate({&origin, 1}).node[0] == 0;
  }
  context.record("voxel/equality_found", found);
}

void record_seeds(ExperimentContext& context) {
  constexpr std::uint64_t seeds = 30;
  std::vector<double> edges;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    context.progress(fmt::format("figure 46 with seed {} of {}", seed, seeds));
    TreeParameters parameters = thesis_tree("figure-46");
    parameters.seed = seed;
    edges.push_back(
        static_cast<double>(grow_quickly(make_seedling(parameters)).skeleton.edge_count()));
  }
  double mean = 0.0, squares = 0.0;
  for (const double e : edges) mean += e / static_cast<double>(seeds);
  for (const double e : edges) squares += (e - mean) * (e - mean);
  const double deviation = std::sqrt(squares / static_cast<double>(seeds - 1));
  context.record("new_seed/seeds", static_cast<std::int64_t>(seeds));
  context.record({.experiment = {},
                  .measurement = "new_seed/coefficient_of_variation",
                  .value = deviation / mean,
                  .sample_size = static_cast<std::int64_t>(seeds),
                  .spread = deviation});
}

/// Figure 40's tree with a constant kill distance, the same share of the influence distance in
/// every iteration: branchings of ten trees together.
void record_kill_sweep(ExperimentContext& context) {
  constexpr std::uint64_t seeds = 10;
  TreeParameters parameters = thesis_tree("figure-40-left");
  for (const int percent : {40, 50, 60, 70, 80, 90}) {
    const double distance = percent / 100.0 * parameters.influence_distance;
    parameters.kill_distance.begin = parameters.kill_distance.end = distance;
    std::size_t branchings = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      parameters.seed = seed;
      const Skeleton tree = grow_quickly(make_seedling(parameters)).skeleton;
      const ChildLists children(tree);
      for (std::size_t node = 0; node < tree.node_count(); ++node)
        branchings += children.of(static_cast<std::int32_t>(node)).size() > 1;
    }
    context.record({.experiment = {},
                    .measurement = "kill_sweep/" + std::to_string(percent) + "-percent/branchings",
                    .value = static_cast<std::int64_t>(branchings),
                    .sample_size = static_cast<std::int64_t>(seeds)});
  }
}

void run(ExperimentContext& context) {
  record_kill_sweep(context);
  record_test_tree(context);
  record_stops(context);
  record_example(context);
  record_repeat_guard(context);
  record_determinism(context);
  record_stems(context);
  record_turning(context);
  record_tropism_weights(context);
  record_voxels(context);
  record_seeds(context);
}

}  // namespace

extern const ExperimentDescriptor growth_laws;
constinit const ExperimentDescriptor growth_laws{
    .id = "brzoska2019/growth-laws",
    .question =
        "Do grown trees keep the laws that the thesis' description of space colonization implies?",
    .source = "[Brzoska2019] sec. 3.4.4, 4.1, 5.2",
    .seconds = {6, 6, 6},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
