// SPDX-License-Identifier: MIT
// What the number of iterations does as a plant's age: to the size of a crown, to the branches that
// a younger crown already has, and to the trunk of an excurrent tree.
#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

using Places = std::set<std::tuple<double, double, double>>;

Places places_of(const Skeleton& tree) {
  Places places;
  for (const Vector3& p : tree.positions()) places.insert({p.x, p.y, p.z});
  return places;
}

struct Ages {
  ByTree young_edges, old_edges;
  ByTree kept_share;  ///< of the young tree's nodes, those at the same places in the old one
};

/// Trees after 20 and after 30 iterations.
Ages record_ages(ExperimentContext& context, const std::string& name,
                 const TreeParameters& parameters) {
  Ages ages;
  ages.kept_share = record_trees(context, name + "/kept-share", "1", [&](std::size_t number) {
    TreeParameters young = tree_of_trend(parameters, context, number), old = young;
    young.iterations = 20;
    old.iterations = 30;
    const Skeleton before = grow_seedling(make_seedling(young), context).skeleton;
    const Skeleton after = grow_seedling(make_seedling(old), context).skeleton;
    ages.young_edges.push_back(static_cast<double>(before.edge_count()));
    ages.old_edges.push_back(static_cast<double>(after.edge_count()));
    const Places later = places_of(after);
    std::int64_t kept = 0;
    for (const Vector3& p : before.positions()) kept += later.contains({p.x, p.y, p.z});
    return static_cast<double>(kept) / static_cast<double>(before.node_count());
  });
  record_trend(context, name + "/older-is-larger", ages.old_edges, ages.young_edges);
  return ages;
}

void record_crowns(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-40-left");
  record_ages(context, "shrinking-kill-distance", parameters);
  parameters.kill_distance.begin = parameters.kill_distance.end =
      couple_to_gnarliness(0.8).kill_distance(0.6);
  const Ages constant = record_ages(context, "constant-kill-distance", parameters);
  context.record(
      {.experiment = {},
       .measurement = "constant-kill-distance/least-kept-share",
       .value = *std::min_element(constant.kept_share.begin(), constant.kept_share.end()),
       .sample_size = static_cast<std::int64_t>(trees_per_trend),
       .seed = context.seed()});
}

/// Length along the trunk inside the crown.
double trunk_length(const Seedling& seedling) {
  double length = 0.0;
  for (auto i = static_cast<std::size_t>(seedling.crown_root) + 1;
       i < seedling.skeleton.node_count(); ++i)
    length += norm(seedling.skeleton.positions()[i] - seedling.skeleton.positions()[i - 1]);
  return length;
}

/// Figure 42's excurrent tree, younger and older, and in clouds of other heights.
void record_trunks(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-42-left");
  for (const int iterations : {7, 14, 28}) {
    parameters.iterations = iterations;
    const Seedling seedling = make_seedling(parameters);
    const GrowthResult result = grow_seedling(seedling, context);
    const std::string name = fmt::format("trunk/{:02}-iterations", iterations);
    context.record(name + "/length", trunk_length(seedling), "length");
    context.record(
        name + "/crown-edges",
        static_cast<std::int64_t>(result.skeleton.node_count() - seedling.skeleton.node_count()),
        "edges");
  }
  parameters = thesis_tree("figure-42-left");
  const double height = parameters.cloud.radii.y;
  for (const int percent : {50, 100, 200}) {
    parameters.cloud.radii.y = percent / 100.0 * height;
    const Seedling seedling = make_seedling(parameters);
    context.record(
        fmt::format("trunk/{:03}-percent-of-the-height/length-per-cloud-height", percent),
        trunk_length(seedling) / extent_of(seedling.attraction_points).extent().y);
  }
}

void run(ExperimentContext& context) {
  record_crowns(context);
  record_trunks(context);
}

}  // namespace

extern const ExperimentDescriptor age;
constinit const ExperimentDescriptor age{
    .id = "brzoska2019/age",
    .question = "Is the number of iterations a plant's age?",
    .source = "[Brzoska2019] sec. 4.1, 6.1.1 (FAO07), 6.2",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
