// SPDX-License-Identifier: MIT
// How full the thesis' trees grow their clouds, and what becomes of a crown whose cloud is just
// full.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "experiments/brzoska2019/paired_trees.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// Points that are left when the thesis' trees are grown, with the author's random numbers.
void record_points_left(ExperimentContext& context) {
  for (const char* figure :
       {"figure-40-left", "figure-41-left", "figure-42-left", "figure-43-left", "figure-44-left",
        "figure-45-left", "figure-46-left", "figure-47-left", "figure-47-right", "figure-48-left",
        "figure-49-left", "figure-49-right", "figure-50-left", "figure-51", "figure-52",
        "figure-53-left", "figure-53-middle", "figure-53-right"}) {
    context.progress(figure);
    const TreeParameters parameters = thesis_tree(figure);
    const Seedling seedling = make_seedling(parameters);
    const GrowthResult result = grow_seedling(seedling, context);
    context.record({.experiment = {},
                    .measurement = fmt::format("points-left/{}/share", figure),
                    .value = static_cast<double>(result.live_points) /
                             static_cast<double>(seedling.attraction_points.size()),
                    .seed = parameters.seed});
  }
}

/// Directions spread evenly over the sphere, on a spiral from top to bottom.
Vector3 direction(int index, int count) {
  const double y = 1.0 - 2.0 * (index + 0.5) / count;
  const double ring = std::sqrt(1.0 - y * y);
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  return {ring * std::cos(golden_angle * index), y, ring * std::sin(golden_angle * index)};
}

double reach(std::span<const Vector3> places, const Vector3& towards) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Vector3& place : places) farthest = std::max(farthest, dot(place, towards));
  return farthest;
}

/// How far the convex hulls of crown and cloud are apart in 500 directions.
struct HullGaps {
  double largest = 0.0;  ///< their Hausdorff distance, but for the spacing of the directions
  double mean = 0.0;
};

HullGaps hull_gaps(std::span<const Vector3> crown, std::span<const Vector3> cloud) {
  constexpr int directions = 500;
  HullGaps gaps;
  for (int i = 0; i < directions; ++i) {
    const Vector3 towards = direction(i, directions);
    const double gap = std::abs(reach(crown, towards) - reach(cloud, towards));
    gaps.largest = std::max(gaps.largest, gap);
    gaps.mean += gap / directions;
  }
  return gaps;
}

/// Figure 48's tree in a cloud of its own size times `factor`: largest gaps, over that size.
ByTree record_hulls(ExperimentContext& context, const std::string& name, double factor) {
  TreeParameters parameters = thesis_tree("figure-48-left");
  const double height = 2.0 * parameters.cloud.radii.y *
                        (1.0 - parameters.cloud.cutoff_bottom - parameters.cloud.cutoff_top);
  parameters.cloud.radii = factor * parameters.cloud.radii;
  ByTree means;
  const ByTree largest =
      record_trees(context, name + "/largest-gap-per-height", "1", [&](std::size_t number) {
        const Seedling seedling = make_seedling(tree_of_trend(parameters, context, number));
        const Skeleton tree = grow_seedling(seedling, context).skeleton;
        const auto root = static_cast<std::size_t>(seedling.crown_root);
        const std::span<const Vector3> nodes(tree.positions().data(), tree.node_count());
        const HullGaps gaps = hull_gaps(nodes.subspan(root), seedling.attraction_points);
        means.push_back(gaps.mean / parameters.step_length);
        return gaps.largest / (factor * height);
      });
  const ByTree in_steps = record_trees(context, name + "/mean-gap-in-steps", "steps",
                                       [&](std::size_t number) { return means[number]; });
  record_trend(context, name + "/mean-gap-below-one-step", ByTree(in_steps.size(), 1.0), in_steps);
  return largest;
}

void run(ExperimentContext& context) {
  record_points_left(context);
  const ByTree full = record_hulls(context, "hull/just-full", 1.0);
  const ByTree roomy = record_hulls(context, "hull/twice-as-large", 2.0);
  record_trend(context, "hull/twice-as-large-over-just-full", roomy, full);
}

}  // namespace

extern const ExperimentDescriptor filled_cloud;
constinit const ExperimentDescriptor filled_cloud{
    .id = "brzoska2019/filled-cloud",
    .question = "Which trees fill their clouds, and does a crown take the shape of a full cloud?",
    .source = "[Brzoska2019] sec. 6.2, fig. 40 to 53",
    .seconds = {1.5, 1.5, 1.5},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
