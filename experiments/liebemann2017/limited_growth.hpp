// SPDX-License-Identifier: MIT
// Trees under the conditions of [Liebemann2017] sec. 3.5, in the core and in the literal loop.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/tree/branch_depth.hpp"
#include "core/tree/branches.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"
#include "experiments/liebemann2017/random_words.hpp"

namespace phytobench::experiments::liebemann2017 {

/// A quarter of the area and of the points of figure 3.2, the root at the lowest place. Nodes do
/// not repeat, so that growth ends.
inline Seedling quarter_scene(std::uint64_t seed, std::uint64_t number) {
  const RoundRegion disc = round_region(RoundShape::disc, ring_radius / 2.0);
  return without_repeats(
      scene(cloud(disc, ring_points / 4, seed, 600 + number), {0, -ring_radius / 2.0, 0}, 200));
}

/// With that value of max_NG.
inline Seedling resting(Seedling seedling, std::int32_t max_NG) {
  seedling.growth.limits.rest_iterations = max_NG;
  return seedling;
}

/// Of step 1, as a share of those of another run.
inline double share_of_distances(const GrowthResult& result, const GrowthResult& all) {
  return static_cast<double>(result.work.search_evaluations) /
         static_cast<double>(all.work.search_evaluations);
}

inline std::uint64_t clouds_of(const ExperimentContext& context) {
  return context.tier() == Tier::smoke ? 3 : context.tier() == Tier::quick ? 8 : 20;
}

inline std::int64_t greatest_degree(const Skeleton& skeleton) {
  const ChildLists successors(skeleton);
  std::size_t greatest = 0;
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(skeleton.node_count()); ++v)
    greatest = std::max(greatest, successors.of(v).size());
  return static_cast<std::int64_t>(greatest);
}

inline std::vector<std::int32_t> depths_at_creation(const Skeleton& skeleton) {
  return branch_depths(skeleton, BranchDepthReading::at_creation);
}

inline std::int64_t greatest_Z(const Skeleton& skeleton) {
  const std::vector<std::int32_t> depths = depths_at_creation(skeleton);
  return *std::max_element(depths.begin(), depths.end());
}

/// The tree of the literal loop in the same scene, under the same conditions.
inline oracles::liebemann2017::ColonizedTree literal_tree(const Seedling& seedling) {
  auto problem = literal_scene(seedling);
  const GrowthLimits& limits = seedling.growth.limits;
  problem.max_NG = limits.rest_iterations;
  problem.weighted_growth = limits.step_weighting == StepWeighting::by_branch_depth;
  return oracles::liebemann2017::colonize(problem);
}

/// Nodes that only one of both trees has; points left otherwise count as one.
inline std::int64_t differs_from_literal(const Seedling& seedling, const GrowthResult& result) {
  const auto literal = literal_tree(seedling);
  return without_counterpart(literal, result.skeleton) +
         (literal.nodes.size() != result.skeleton.node_count()) +
         (literal.left.size() != result.live_points);
}

}  // namespace phytobench::experiments::liebemann2017
