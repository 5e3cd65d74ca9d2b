// SPDX-License-Identifier: MIT
// What makes a crown branch densely or sparsely. Density is branchings per volume of a cloud that
// has been grown full; per length of branch and tips are recorded beside it.
#include <algorithm>

#include <fmt/format.h>

#include "core/tree/habit.hpp"
#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// A crown small enough to be full long before the last iteration, with the author's largest
/// influence distance and the density of points that belongs to it.
TreeParameters small_crown() {
  TreeParameters parameters;
  parameters.cloud.radii = {3.0, 4.2, 2.7};
  parameters.iterations = 200;
  parameters.influence_distance = couple_to_gnarliness(0.0).influence_distance;
  parameters.cloud_density = couple_to_gnarliness(0.0).cloud_density;
  return parameters;
}

/// The same kill distance in all iterations.
void keep_kill_distance(TreeParameters& parameters, double distance) {
  parameters.kill_distance.begin = parameters.kill_distance.end = distance;
}

/// Records what grows with one setting, and returns the densities in the cloud's volume.
ByTree record_densities(ExperimentContext& context, const std::string& name,
                        const TreeParameters& parameters) {
  ByTree per_length;
  const ByTree per_volume =
      record_trees(context, name + "/branchings-per-volume", "1/volume", [&](std::size_t number) {
        const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
        const Skeleton tree = grow_seedling(seedling, context).skeleton;
        const double crown_edges = static_cast<double>(tree.node_count()) -
                                   static_cast<double>(seedling.skeleton.node_count());
        const auto branchings = static_cast<double>(branching_count(tree));
        per_length.push_back(crown_edges > 0.0 ? branchings / (crown_edges * parameters.step_length)
                                               : 0.0);
        return branchings / volume(parameters.cloud);
      });
  alsweis::record_mean(context, name + "/branchings-per-length/mean", per_length, "1/length");
  return per_volume;
}

/// Fig. 19: larger and larger kill distances.
void record_kill_distances(ExperimentContext& context) {
  std::vector<std::string> names;
  std::vector<ByTree> densities;
  for (const double distance : {0.2, 0.4, 0.6, 0.8, 1.0, 1.2}) {
    TreeParameters parameters = small_crown();
    keep_kill_distance(parameters, distance);
    names.push_back(fmt::format("{:.1f}", distance));
    densities.push_back(record_densities(context, "kill-distance/" + names.back(), parameters));
  }
  record_falling(context, "kill-distance", names, densities);
}

/// The start settings with a constant kill distance: tips, as in a plain replay of the thesis.
void record_tips(ExperimentContext& context) {
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.8);
  std::vector<std::string> names;
  std::vector<ByTree> tips;
  for (const int percent : {80, 60, 40, 20, 0}) {
    TreeParameters parameters;
    keep_kill_distance(parameters, coupling.kill_distance(percent / 100.0));
    names.push_back(fmt::format("density-{}-percent", percent));
    tips.push_back(record_trees(
        context, "start-tree/" + names.back() + "/tips", "tips", [&](std::size_t number) {
          const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
          return static_cast<double>(tip_count(grow_seedling(seedling, context).skeleton));
        }));
    context.record({.experiment = {},
                    .measurement = "start-tree/" + names.back() + "/tips-of-the-program",
                    .value = static_cast<std::int64_t>(
                        tip_count(grow_seedling(make_seedling(parameters), context).skeleton)),
                    .unit = "tips",
                    .seed = parameters.seed});
  }
  record_falling(context, "start-tree", names, tips);
}

/// Fig. 19: fewer and fewer points.
void record_point_numbers(ExperimentContext& context) {
  std::vector<std::string> names;
  std::vector<ByTree> densities;
  for (const double points_per_volume : {24.0, 12.0, 6.0, 3.0, 1.5}) {
    TreeParameters parameters = small_crown();
    keep_kill_distance(parameters, 0.4);
    parameters.cloud_density = points_per_volume;
    names.push_back(fmt::format("{}", points_per_volume));
    densities.push_back(record_densities(context, "points/" + names.back(), parameters));
  }
  record_falling(context, "points", names, densities);
}

/// Sec. 4.1: how nearly a density stays the same over all influence distances: 1 if it does, 0 if
/// one of the trees does not grow.
ByTree least_per_largest(const std::vector<ByTree>& densities) {
  ByTree factors;
  for (std::size_t tree = 0; tree < trees_per_trend; ++tree) {
    double least = densities[0][tree], largest = least;
    for (const ByTree& values : densities) {
      least = std::min(least, values[tree]);
      largest = std::max(largest, values[tree]);
    }
    factors.push_back(largest > 0.0 ? least / largest : 0.0);
  }
  return factors;
}

/// Which cloud goes with which influence distance.
enum class Cloud { kept, adapted };

/// The author's influence distances, each with the kill distance of a branch density of one half.
ByTree record_influence_distances(ExperimentContext& context, Cloud cloud) {
  const std::string group =
      cloud == Cloud::kept ? "influence/kept-cloud" : "influence/adapted-cloud";
  std::vector<std::string> names;
  std::vector<ByTree> densities;
  for (const double gnarliness : {1.0, 0.5, 0.0}) {
    const GnarlinessCoupling coupling = couple_to_gnarliness(gnarliness);
    TreeParameters parameters = small_crown();
    parameters.influence_distance = coupling.influence_distance;
    parameters.cloud_density =
        couple_to_gnarliness(cloud == Cloud::adapted ? gnarliness : 0.5).cloud_density;
    keep_kill_distance(parameters, coupling.kill_distance(0.5));
    names.push_back(fmt::format("{:.1f}", coupling.influence_distance));
    densities.push_back(record_densities(context, group + "/" + names.back(), parameters));
  }
  record_falling(context, group, names, densities);
  const ByTree factors = least_per_largest(densities);
  return record_trees(context, group + "/least-per-largest", "1",
                      [&](std::size_t number) { return factors[number]; });
}

void record_kill_limits(ExperimentContext& context) {
  for (int tenths = 0; tenths <= 10; ++tenths) {
    const GnarlinessCoupling coupling = couple_to_gnarliness(tenths / 10.0);
    context.record(fmt::format("kill-limit/gnarliness-{:02}/share-of-influence", tenths),
                   coupling.kill_distance_max / coupling.influence_distance);
  }
}

void run(ExperimentContext& context) {
  record_kill_distances(context);
  record_tips(context);
  record_point_numbers(context);
  const ByTree kept = record_influence_distances(context, Cloud::kept);
  const ByTree adapted = record_influence_distances(context, Cloud::adapted);
  record_trend(context, "influence/adapting-steadies", adapted, kept);
  record_kill_limits(context);
}

}  // namespace

extern const ExperimentDescriptor branch_density;
constinit const ExperimentDescriptor branch_density{
    .id = "brzoska2019/branch-density",
    .question = "Which settings make a crown branch densely, and which sparsely?",
    .source = "[Brzoska2019] sec. 3.4.4, 4.1, fig. 19",
    .seconds = {1.2, 1.2, 1.2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
