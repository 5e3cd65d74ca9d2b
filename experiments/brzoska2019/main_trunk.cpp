// SPDX-License-Identifier: MIT
// When a crown has a main trunk: the share that the thickest branch has of the cross-section of all
// branches, at half the crown's height and as a mean over its heights. 1 would be a trunk alone; in
// a crown of many main branches it is small.
#include <algorithm>

#include <fmt/format.h>

#include "core/geometry/bounding_box.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/habit.hpp"
#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct TrunkShares {
  double half_height = 0.0;
  double mean = 0.0;  ///< over nine heights that cut the crown into ten
};

TrunkShares trunk_shares(const Skeleton& tree, std::int32_t crown_root,
                         const PlantParameters& look) {
  constexpr int parts = 10;
  const std::vector<double> radii = branch_radii(tree, look.tip_radius, look.radius_exponent);
  BoundingBox crown;
  for (auto i = static_cast<std::size_t>(crown_root); i < tree.node_count(); ++i)
    crown.extend(tree.positions()[i]);
  TrunkShares shares;
  for (int part = 1; part < parts; ++part) {
    const double height = crown.low().y + part * crown.extent().y / parts;
    const double share = trunk_share(tree, radii, height);
    shares.mean += share / (parts - 1);
    if (2 * part == parts) shares.half_height = share;
  }
  return shares;
}

/// Means over the heights, returned; half the height is recorded beside them.
ByTree record_shares(ExperimentContext& context, const std::string& name,
                     const std::function<TrunkShares(std::size_t)>& shares_of_tree,
                     std::size_t trees = trees_per_trend, const SeedOfTree& seed_of_tree = {}) {
  ByTree at_half;
  const ByTree means = record_trees(
      context, name + "/mean-trunk-share", "1",
      [&](std::size_t number) {
        const TrunkShares shares = shares_of_tree(number);
        at_half.push_back(shares.half_height);
        return shares.mean;
      },
      trees, seed_of_tree);
  record_trees(
      context, name + "/trunk-share-at-half-height", "1",
      [&](std::size_t number) { return at_half[number]; }, trees, seed_of_tree);
  return means;
}

/// Figure 41's tall cloud, grown full, without tropism: the influence distance alone makes a trunk.
TreeParameters tall_crown(double influence_distance) {
  TreeParameters parameters = thesis_tree("figure-41-left");
  parameters.influence_distance = influence_distance;
  parameters.kill_distance.begin = parameters.kill_distance.end = 0.4;
  parameters.iterations = 80;
  parameters.tropism_direction = {};
  return parameters;
}

ByTree shares_at(ExperimentContext& context, const std::string& name, double influence_distance,
                 std::size_t trees) {
  const TreeParameters parameters = tall_crown(influence_distance);
  return record_shares(
      context, name,
      [&](std::size_t number) {
        const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
        const Skeleton tree = grow_seedling(seedling, context).skeleton;
        return trunk_shares(tree, seedling.crown_root, parameters.plant);
      },
      trees);
}

/// Fig. 20, larger distances first.
void record_influence_distances(ExperimentContext& context) {
  std::vector<std::string> names;
  std::vector<ByTree> shares;
  for (const double distance : {16.0, 8.0, 4.0, 2.0, 1.0}) {
    names.push_back(fmt::format("{:.0f}", distance));
    shares.push_back(shares_at(context, "influence/" + names.back(), distance, trees_per_trend));
  }
  record_falling(context, "influence", names, shares);
  record_trend(context, "influence/4-to-1", shares[2], shares.back());
  record_trend(context, "influence/16-to-1", shares.front(), shares.back());
}

/// The weakest step of the rise, from 2 to 4.
void record_weakest_step(ExperimentContext& context) {
  const ByTree four = shares_at(context, "more-trees/4", 4.0, trees_per_weak_trend);
  const ByTree two = shares_at(context, "more-trees/2", 2.0, trees_per_weak_trend);
  record_trend(context, "more-trees/4-to-2", four, two);
}

ByTree record_habit(ExperimentContext& context, const char* figure) {
  const TreeParameters parameters = thesis_tree(figure);
  FullTrees trees(parameters, context);
  const std::string name = std::string("habit/") + figure;
  const ByTree shares = record_shares(
      context, name,
      [&](std::size_t) {
        const GrownTree tree = trees.next();
        return trunk_shares(tree.skeleton, tree.seedling.crown_root, parameters.plant);
      },
      trees_per_trend, [&](std::size_t number) { return trees.seed(number); });
  context.record(name + "/left-out", trees.left_out(), "trees");
  return shares;
}

/// Sec. 2.1.4: the thesis' excurrent tree and its broad decurrent one.
void record_habits(ExperimentContext& context) {
  const ByTree excurrent = record_habit(context, "figure-42-left");
  const ByTree decurrent = record_habit(context, "figure-40-left");
  const double least = *std::min_element(excurrent.begin(), excurrent.end());
  context.record("habit/least-excurrent", least);
  context.record("habit/most-decurrent", *std::max_element(decurrent.begin(), decurrent.end()));
  record_trend(context, "habit/below-every-excurrent", ByTree(decurrent.size(), least), decurrent);
}

void run(ExperimentContext& context) {
  record_influence_distances(context);
  record_weakest_step(context);
  record_habits(context);
}

}  // namespace

extern const ExperimentDescriptor main_trunk;
constinit const ExperimentDescriptor main_trunk{
    .id = "brzoska2019/main-trunk",
    .question =
        "When does a crown have a main trunk, and does the share of its thickest branch "
        "tell excurrent from decurrent trees?",
    .source = "[Brzoska2019] sec. 2.1.4, 3.4.4, fig. 20",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
