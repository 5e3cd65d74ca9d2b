// SPDX-License-Identifier: MIT
// The three steps of sec. 3.3, checked in every iteration of trees among random influence points.
#include <algorithm>
#include <cmath>

#include "core/tree/branch_angle_reduction.hpp"
#include "core/tree/branches.hpp"
#include "experiments/liebemann2017/fork_angles.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/step_faults.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

double longest_deviation(const Skeleton& skeleton) {
  double deviation = 0.0;
  for (std::size_t v = 1; v < skeleton.node_count(); ++v)
    deviation =
        std::max(deviation,
                 std::abs(norm(skeleton.positions()[v] - skeleton.position(skeleton.parents()[v])) -
                          step_length));
  return deviation;
}

/// Root radius by eq. 3.4 against the literal sum from the tips, as a share of it.
double radius_off(const Skeleton& skeleton) {
  std::vector<int> predecessors(skeleton.parents().begin(), skeleton.parents().end());
  const oracles::liebemann2017::TreeGraph graph(predecessors);
  const double literal = oracles::liebemann2017::radii(graph, tip_radius, ring_g)[0];
  return std::abs(branch_radii(skeleton, tip_radius, ring_g)[0] / literal - 1.0);
}

struct Totals {
  Faults faults;
  std::int64_t nodes = 0, different = 0, not_trees = 0, space_nodes_off_plane = 0;
  double step_off = 0.0, radius_off = 0.0;
  std::int64_t angles_not_reduced = 0, roots_moved = 0, parents_changed = 0;
};

void measure(const Seedling& seedling, Totals& totals) {
  const GrowthResult result = grow(seedling);
  const Skeleton& skeleton = result.skeleton;
  totals.nodes += nodes_of(result);
  totals.different += differs_from_oracle(seedling, result);
  follow(seedling, result, totals.faults);
  totals.step_off = std::max(totals.step_off, longest_deviation(skeleton));
  totals.not_trees += !oracles::liebemann2017::is_tree(
      std::vector<int>(skeleton.parents().begin(), skeleton.parents().end()));
  totals.radius_off = std::max(totals.radius_off, radius_off(skeleton));
  for (const Vector3& place : skeleton.positions()) totals.space_nodes_off_plane += place.z != 0.0;
  if (seedling.growth.variant.repeat_guard == RepeatGuard::off) return;
  const Skeleton reduced = reduce_branch_angles(skeleton, 0.5);
  totals.angles_not_reduced += !(mean_fork_angle_deg(reduced) < mean_fork_angle_deg(skeleton));
  totals.roots_moved += reduced.position(0) != skeleton.position(0);
  totals.parents_changed += !std::equal(reduced.parents().begin(), reduced.parents().end(),
                                        skeleton.parents().begin(), skeleton.parents().end());
}

void record(ExperimentContext& context, const std::string& name, const Totals& totals) {
  const auto put = [&](const char* what, RecordValue value, const char* unit = "1") {
    record_seeded(context, name + "/" + what, std::move(value), unit);
  };
  put("nodes", totals.nodes);
  put("iterations", totals.faults.iterations);
  put("differs_from_oracle", totals.different);
  put("wrong_influences", totals.faults.influencing_points);
  put("wrong_successors", totals.faults.growing_nodes);
  put("wrong_points_left", totals.faults.points_left);
  put("step_off", totals.step_off, "length");
  put("not_trees", totals.not_trees);
  put("root_radius_off", totals.radius_off);
  put("nodes_off_plane", totals.space_nodes_off_plane);
  put("angles_not_reduced", totals.angles_not_reduced);
  put("roots_moved", totals.roots_moved);
  put("parents_changed", totals.parents_changed);
}

void run(ExperimentContext& context) {
  const std::uint64_t clouds = context.tier() == Tier::smoke ? 2 : 8;
  Totals plane, space;
  for (std::uint64_t i = 0; i < clouds; ++i) {
    context.progress(fmt::format("cloud {}", i));
    const Seedling flat = scene(
        cloud(round_region(RoundShape::disc, 200), 300, context.seed(), 100 + i), {0, -200, 0}, 60);
    const Seedling round =
        scene(cloud(round_region(RoundShape::sphere_shell, 120), 300, context.seed(), 200 + i),
              {0, -120, 0}, 60);
    for (const Seedling& seedling : {flat, without_repeats(flat)}) measure(seedling, plane);
    for (const Seedling& seedling : {round, without_repeats(round)}) measure(seedling, space);
  }
  record(context, "plane", plane);
  record(context, "space", space);
}

}  // namespace

extern const ExperimentDescriptor growth_steps;
constinit const ExperimentDescriptor growth_steps{
    .id = "liebemann2017/growth-steps",
    .question = "Do the three steps do in every iteration what sec. 3.3 says?",
    .source = "[Liebemann2017] sec. 3.1, 3.3, 3.4",
    .seconds = {0.3, 1.0, 1.0},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
