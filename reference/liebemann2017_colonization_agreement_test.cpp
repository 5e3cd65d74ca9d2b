// SPDX-License-Identifier: MIT
// Growth in the core beside the literal loops of [Liebemann2017] sec. 3.3 and 3.5: the same nodes
// at the same places with the same branch depths, and as many distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/colonization/test_discs.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branch_angle_reduction.hpp"
#include "core/tree/branch_depth.hpp"
#include "core/tree/curve_reduction.hpp"
#include "reference/oracles/liebemann2017_curve_reduction.hpp"
#include "reference/oracles/liebemann2017_space_colonization.hpp"

namespace phytobench {
namespace {

namespace literal = oracles::liebemann2017;

/// Node, parent and branch depth. The oracle numbers its nodes otherwise, and adds up otherwise.
using Entry = std::array<std::int64_t, 6>;

std::int64_t rounded(double coordinate) {
  return std::llround(1e6 * coordinate);
}

std::vector<Entry> entries(const Skeleton& tree) {
  const auto depths = branch_depths(tree, BranchDepthReading::at_creation);
  std::vector<Entry> all;
  for (std::size_t i = 1; i < tree.node_count(); ++i) {
    const Vector3& node = tree.positions()[i];
    const Vector3& parent = tree.position(tree.parents()[i]);
    all.push_back({rounded(node.x), rounded(node.y), rounded(node.z), rounded(parent.x),
                   rounded(parent.y), depths[i]});
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Entry> entries(const literal::ColonizedTree& tree) {
  std::vector<Entry> all;
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const literal::Point& node = tree.nodes[i];
    const literal::Point& parent = tree.nodes[static_cast<std::size_t>(tree.predecessors[i])];
    all.push_back({rounded(node.x), rounded(node.y), rounded(node.z), rounded(parent.x),
                   rounded(parent.y), tree.Z[i]});
  }
  std::sort(all.begin(), all.end());
  return all;
}

literal::Point as_point(const Vector3& v) {
  return {v.x, v.y, v.z};
}

int or_unlimited(std::int32_t limit) {
  return limit == GrowthLimits::unlimited ? literal::ColonizationProblem::unlimited : limit;
}

literal::ColonizationProblem as_problem(const Seedling& seedling) {
  const GrowthParameters& growth = seedling.growth;
  literal::ColonizationProblem problem;
  for (const Vector3& point : seedling.attraction_points) problem.S.push_back(as_point(point));
  problem.root = as_point(seedling.skeleton.positions()[0]);
  problem.d_i = growth.influence_distance;
  problem.d_k = growth.kill_distance.begin;
  problem.D = growth.step_length;
  problem.T = as_point(growth.tropism);
  problem.most_iterations = growth.iterations;
  problem.boundary = growth.variant.kill_boundary == Boundary::inclusive
                         ? literal::Boundary::within
                         : literal::Boundary::outside;
  problem.tropism = growth.variant.tropism_order == TropismOrder::before_normalising
                        ? literal::Tropism::added_to_the_sum
                        : literal::Tropism::added_to_the_unit_vector;
  problem.same_successor_again = growth.variant.repeat_guard == RepeatGuard::on
                                     ? literal::SameSuccessorAgain::rejected
                                     : literal::SameSuccessorAgain::allowed_as_printed;
  problem.zero_over_zero = literal::ZeroOverZero::skipped;
  problem.max_grad = or_unlimited(growth.limits.most_children);
  problem.max_Z = or_unlimited(growth.limits.most_branch_depth);
  problem.max_NG = or_unlimited(growth.limits.rest_iterations);
  problem.weighted_growth = growth.limits.step_weighting == StepWeighting::by_branch_depth;
  problem.stop_at_standstill = true;
  return problem;
}

bool same_end(literal::Stop stop, StopReason reason) {
  switch (stop) {
    case literal::Stop::all_points_removed:
      return reason == StopReason::no_points_left;
    case literal::Stop::no_node_in_reach:
      return reason == StopReason::no_point_in_range || reason == StopReason::every_node_rests;
    case literal::Stop::most_iterations:
      return reason == StopReason::iteration_limit;
    case literal::Stop::standstill:
      return reason == StopReason::no_new_node || reason == StopReason::no_child_allowed;
    case literal::Stop::undefined:
      return false;
  }
  return false;
}

void expect_same_growth(const Seedling& seedling, const std::string& what) {
  const auto engine = engine_named("squared_scan").create();
  const GrowthResult grown = grow_crown(seedling, *engine);
  const literal::ColonizedTree expected = literal::colonize(as_problem(seedling));
  ASSERT_EQ(entries(grown.skeleton), entries(expected)) << what;
  EXPECT_EQ(grown.live_points, expected.left.size()) << what;
  EXPECT_TRUE(same_end(expected.stop, grown.stop_reason))
      << what << ": " << name_of(grown.stop_reason);
  EXPECT_EQ(grown.work.search_evaluations, expected.distances_of_step_1) << what;
}

std::vector<GrowthLimits> limits_to_try() {
  constexpr std::int32_t none = GrowthLimits::unlimited;
  std::vector<GrowthLimits> all;
  for (const std::int32_t children : {none, 1, 2})
    for (const std::int32_t depth : {none, 0, 2})
      for (const std::int32_t rest : {none, 1, 3})
        for (const StepWeighting weighting : {StepWeighting::none, StepWeighting::by_branch_depth})
          if (weighting == StepWeighting::none || depth == 2)
            all.push_back({children, depth, rest, weighting});
  return all;
}

std::string text_of(const GrowthLimits& limits) {
  return "limits " + std::to_string(limits.most_children) + ", " +
         std::to_string(limits.most_branch_depth) + ", " + std::to_string(limits.rest_iterations) +
         (limits.step_weighting == StepWeighting::none ? "" : ", weighted");
}

TEST(LiebemannColonizationOracle, GrowsTheSameTreeUnderEveryLimit) {
  std::uint64_t seed = 0;
  for (const GrowthLimits& limits : limits_to_try()) {
    Seedling seedling = disc_scene(seed++, 120);
    seedling.growth.limits = limits;
    ASSERT_NO_FATAL_FAILURE(expect_same_growth(seedling, text_of(limits)));
  }
}

TEST(LiebemannColonizationOracle, GrowsTheSameTreeWithTropismBoundariesAndRepeats) {
  for (const TropismOrder order :
       {TropismOrder::before_normalising, TropismOrder::after_normalising})
    for (const Boundary boundary : {Boundary::inclusive, Boundary::exclusive})
      for (const RepeatGuard guard : {RepeatGuard::on, RepeatGuard::off}) {
        Seedling seedling = disc_scene(3, 60);
        seedling.growth.tropism = {0.2, 0.4, 0};
        seedling.growth.variant.tropism_order = order;
        seedling.growth.variant.influence_boundary = boundary;
        seedling.growth.variant.kill_boundary = boundary;
        seedling.growth.variant.repeat_guard = guard;
        ASSERT_NO_FATAL_FAILURE(expect_same_growth(seedling, "variant"));
        seedling.growth.limits.most_children = 3;
        ASSERT_NO_FATAL_FAILURE(expect_same_growth(seedling, "variant with limit"));
      }
}

// The comparison sees a limit that one of the two does not have.
TEST(LiebemannColonizationOracle, SeesOneLimitThatDiffers) {
  Seedling seedling = disc_scene(1, 120);
  const auto engine = engine_named("squared_scan").create();
  const auto grown = entries(grow_crown(seedling, *engine).skeleton);
  seedling.growth.limits.most_branch_depth = 1;
  EXPECT_NE(grown, entries(literal::colonize(as_problem(seedling))));
}

literal::PlacedTree as_placed(const Skeleton& tree) {
  literal::PlacedTree placed;
  for (const Vector3& position : tree.positions()) placed.nodes.push_back(as_point(position));
  for (const std::int32_t parent : tree.parents()) placed.predecessors.push_back(parent);
  return placed;
}

TEST(LiebemannReductionOracle, KeepsTheSameNodesInBothOrders) {
  const auto engine = engine_named("squared_scan").create();
  const Skeleton tree = grow_crown(disc_scene(1), *engine).skeleton;
  for (const double cosine : {0.7, 0.9, 0.95, 0.99, 0.999})
    for (const ReductionOrder order : {ReductionOrder::simultaneous, ReductionOrder::root_to_tip}) {
      const auto kept = literal::kept_nodes(as_placed(tree), cosine,
                                            order == ReductionOrder::simultaneous
                                                ? literal::ReductionOrder::simultaneous
                                                : literal::ReductionOrder::root_to_tip);
      const ReducedSkeleton reduced = reduce_curves(tree, {cosine, order});
      ASSERT_EQ(std::vector<std::int32_t>(kept.begin(), kept.end()), reduced.node_before);
      ASSERT_LT(kept.size(), tree.node_count());
    }
}

TEST(LiebemannReductionOracle, NarrowsAnglesAlike) {
  const auto engine = engine_named("squared_scan").create();
  const Skeleton tree = grow_crown(disc_scene(2), *engine).skeleton;
  const Skeleton reduced = reduce_branch_angles(tree, 0.5);
  const literal::PlacedTree expected = literal::narrowed(as_placed(tree));
  constexpr double rounding = 1e-12;  // coordinates below 1000
  for (std::size_t i = 0; i < tree.node_count(); ++i)
    ASSERT_LT(literal::norm(literal::minus(as_point(reduced.positions()[i]), expected.nodes[i])),
              rounding);
}

}  // namespace
}  // namespace phytobench
