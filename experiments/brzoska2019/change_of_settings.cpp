// SPDX-License-Identifier: MIT
// What happens when a user changes a setting: whether the cloud stays, point for point, and whether
// an engine that is stopped in the middle of one tree grows the next one as a new engine does.
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// The start settings with one line of a tree file changed. Their density of points is kept:
/// gnarliness would set its own.
TreeParameters changed(std::string_view line) {
  return parse_tree_parameters(fmt::format("cloud.density = 26.4\n{}\n", line), "setting");
}

std::vector<Vector3> cloud_of(const TreeParameters& parameters) {
  return make_seedling(parameters).attraction_points;
}

/// Sec. 5.5.3: settings of growth that are none of the cloud, and settings of the look.
void record_same_clouds(ExperimentContext& context) {
  constexpr std::string_view lines[] = {"growth.branch_density_begin = 0.3",
                                        "growth.branch_density_end = 0.6",
                                        "growth.iterations = 20",
                                        "stem.crown_ratio = 0.5",
                                        "branches.thickness = 0.7",
                                        "leaves.per_node = 0.2",
                                        "mesh.circle_resolution = 5"};
  const std::vector<Vector3> cloud = cloud_of(changed(""));
  std::int64_t same = 0;
  for (const std::string_view line : lines) same += cloud_of(changed(line)) == cloud;
  context.record("cloud/settings-changed", static_cast<std::int64_t>(std::size(lines)), "settings");
  context.record("cloud/same-points", same, "settings");
  context.record("cloud/same-points-with-new-seed",
                 std::int64_t{cloud_of(changed("seed = 1")) == cloud});
  context.record("cloud/same-points-with-first-seed-again",
                 std::int64_t{cloud_of(changed("seed = 0")) == cloud});
  // Gnarliness sets the density of the cloud, too: the points of the sparser cloud come first.
  const std::vector<Vector3> denser =
      cloud_of(parse_tree_parameters("cloud.density = 30.0\n", "setting"));
  context.record("cloud/denser-cloud-begins-with-the-sparser",
                 std::int64_t{denser.size() > cloud.size() &&
                              std::equal(cloud.begin(), cloud.end(), denser.begin())});
}

std::string hash_of_tree(const Seedling& seedling, NearestNodeEngine& engine) {
  return tree_hash(grow_crown(seedling, engine, {}).skeleton);
}

/// Fig. 39: the crown's height is changed while a tree grows.
void record_sequence(ExperimentContext& context) {
  const TreeParameters before = changed("");
  const TreeParameters after = changed("cloud.radii = [5.0, 4.0, 4.5]");
  // Steps 2 to 4: growth stops after the iteration in which the slider moves.
  const auto engine = engine_named("node_driven").create();
  constexpr std::size_t moved_in = 10;
  std::size_t notified = 0;
  const GrowthResult stopped =
      grow_crown(make_seedling(before), *engine,
                 {.observer = [&](const PassStatistics&) { return ++notified < moved_in; }});
  context.record("sequence/iterations-before-stop",
                 static_cast<std::int64_t>(stopped.passes.size()), "iterations");
  // Steps 5 and 6: the new radius, and a cloud that has it.
  const Seedling seedling = make_seedling(after);
  const double share = 1.0 - after.cloud.cutoff_top - after.cloud.cutoff_bottom;
  context.record("sequence/cloud-height-over-radius",
                 extent_of(seedling.attraction_points).extent().y / (2.0 * 4.0 * share));
  // Step 7: tropism follows the cloud; were it updated before, another tree would grow.
  const Seedling old = make_seedling(before);
  context.record("sequence/upward-tropism-before", old.growth.tropism.y);
  context.record("sequence/upward-tropism-after", seedling.growth.tropism.y);
  Seedling stale = seedling;
  stale.growth.tropism = old.growth.tropism;
  // Steps 8 to 13: the engine keeps nothing of the first tree, and each iteration is told.
  notified = 0;
  const GrowthResult regrown =
      grow_crown(seedling, *engine, {.observer = [&](const PassStatistics&) {
                   ++notified;
                   return true;
                 }});
  context.record("sequence/iterations", static_cast<std::int64_t>(regrown.passes.size()),
                 "iterations");
  context.record("sequence/notifications", static_cast<std::int64_t>(notified), "notifications");
  const auto fresh_engine = engine_named("node_driven").create();
  context.record("sequence/tree-after-change", tree_hash(regrown.skeleton));
  context.record("sequence/tree-of-fresh-start", hash_of_tree(seedling, *fresh_engine));
  context.record("sequence/tree-with-tropism-of-old-cloud", hash_of_tree(stale, *engine));
}

void run(ExperimentContext& context) {
  record_same_clouds(context);
  record_sequence(context);
}

}  // namespace

extern const ExperimentDescriptor change_of_settings;
constinit const ExperimentDescriptor change_of_settings{
    .id = "brzoska2019/change-of-settings",
    .question = "What does a changed setting do to the cloud and to a tree that is growing?",
    .source = "[Brzoska2019] sec. 5.5.1, 5.5.3, fig. 39",
    .seconds = {0.5, 0.5, 0.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
