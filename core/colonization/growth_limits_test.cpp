// SPDX-License-Identifier: MIT
// Space colonization as [Liebemann2017] describes it, and the limits of its section 3.5. Nodes that
// rest have a file of their own.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "core/colonization/branching_limits.hpp"
#include "core/colonization/test_discs.hpp"
#include "core/colonization/test_growth.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branch_depth.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

constexpr double coordinate_rounding = 1e-9;  // coordinates below 1000

std::size_t distinct_places(const Skeleton& tree) {
  std::set<std::tuple<double, double, double>> places;
  for (const Vector3& p : tree.positions()) places.insert({p.x, p.y, p.z});
  return places.size();
}

std::int32_t most_children(const Skeleton& tree) {
  const ChildLists children(tree);
  std::size_t most = 0;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(tree.node_count()); ++i)
    most = std::max(most, children.of(i).size());
  return static_cast<std::int32_t>(most);
}

std::int32_t deepest_branch(const Skeleton& tree) {
  const auto depths = branch_depths(tree, BranchDepthReading::at_creation);
  return *std::max_element(depths.begin(), depths.end());
}

std::size_t nodes_towards(double length, Boundary kill, Boundary influence = Boundary::inclusive) {
  Seedling seedling = flat_scene({{0, length, 0}}, {}, 50);
  seedling.growth.variant.kill_boundary = kill;
  seedling.growth.variant.influence_boundary = influence;
  return grow(seedling).skeleton.edge_count();
}

TEST(GrowthTowardsOnePoint, TakesAsManyStepsAsTheWayIsLong) {
  EXPECT_EQ(nodes_towards(100.0, Boundary::inclusive), 6u);
  for (const double length : {21.0, 36.0, 52.5, 77.0, 99.0})
    for (const Boundary kill : {Boundary::inclusive, Boundary::exclusive})
      EXPECT_EQ(nodes_towards(length, kill),
                static_cast<std::size_t>(std::ceil((length - 20.0) / 15.0)))
          << length;
}

TEST(GrowthTowardsOnePoint, TakesOneMoreIfItsEndMustNotBeExactlyAtTheKillDistance) {
  for (const std::size_t steps : {1u, 2u, 5u}) {
    const double length = 20.0 + 15.0 * static_cast<double>(steps);
    EXPECT_EQ(nodes_towards(length, Boundary::inclusive), steps);
    EXPECT_EQ(nodes_towards(length, Boundary::exclusive), steps + 1);
  }
}

TEST(GrowthTowardsOnePoint, StartsFromExactlyTheInfluenceDistanceOnlyIfThatIsWithin) {
  using enum Boundary;
  EXPECT_EQ(nodes_towards(100.0, exclusive, inclusive), 6u);
  EXPECT_EQ(nodes_towards(100.0, exclusive, exclusive), 0u);
  EXPECT_EQ(nodes_towards(std::nextafter(100.0, 0.0), exclusive, exclusive), 6u);
}

TEST(LargestWithin, IsTheNextSmallerNumberWithoutTheBoundary) {
  EXPECT_EQ(largest_within(2.0, Boundary::inclusive), 2.0);
  EXPECT_EQ(largest_within(2.0, Boundary::exclusive), std::nextafter(2.0, 0.0));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(largest_within(infinity, Boundary::exclusive), infinity);
}

TEST(GrowthInADiscLaw, EveryEdgeIsOneStep) {
  const Skeleton tree = grow(disc_scene(1)).skeleton;
  ASSERT_GT(tree.edge_count(), 100u);
  for (std::size_t i = 1; i < tree.node_count(); ++i)
    ASSERT_NEAR(norm(tree.positions()[i] - tree.position(tree.parents()[i])), 15.0,
                coordinate_rounding);
}

TEST(GrowthInADiscLaw, AfterEachIterationExactlyThePointsNearNodesAreGone) {
  for (int iterations = 1; iterations <= 30; iterations += 4) {
    const Seedling seedling = disc_scene(2, iterations);
    const GrowthResult result = grow(seedling);
    std::size_t far_from_all = 0;
    for (const Vector3& point : seedling.attraction_points)
      far_from_all += std::none_of(
          result.skeleton.positions().begin(), result.skeleton.positions().end(),
          [&](const Vector3& node) { return squared_distance(node, point) <= 20.0 * 20.0; });
    ASSERT_EQ(result.live_points, far_from_all) << iterations << " iterations";
  }
}

double angle_deg_between_points_and_growth(int points, TropismOrder order) {
  std::vector<Vector3> ahead;
  for (int i = 0; i < points; ++i) ahead.push_back({40.0 + i, 0, 0});
  Seedling seedling = flat_scene(ahead, {}, 1);
  seedling.growth.tropism = {0, 1, 0};
  seedling.growth.variant.tropism_order = order;
  const Vector3 child = grow(seedling).skeleton.positions().back();
  return std::atan2(child.y, child.x) * 180.0 / std::numbers::pi;
}

TEST(Tropism, CountsAsOnePointMoreOrAsMuchAsAllOfThem) {
  for (const int points : {1, 2, 4, 8}) {
    EXPECT_NEAR(angle_deg_between_points_and_growth(points, TropismOrder::before_normalising),
                std::atan(1.0 / points) * 180.0 / std::numbers::pi, coordinate_rounding);
    EXPECT_NEAR(angle_deg_between_points_and_growth(points, TropismOrder::after_normalising), 45.0,
                coordinate_rounding);
  }
}

/// Two points that no node comes between: [Liebemann2017] sec. 5.3.
Seedling two_point_trap(double root_y) {
  Seedling seedling = flat_scene({{40, 0, 0}, {-40, 0, 0}}, {0, root_y, 0}, 500);
  seedling.growth.variant.repeat_guard = RepeatGuard::off;
  return seedling;
}

TEST(TwoPointTrap, GrowsTheSameChildrenForever) {
  const GrowthResult result = grow(two_point_trap(-50.0));
  EXPECT_EQ(result.stop_reason, StopReason::iteration_limit);
  EXPECT_EQ(result.skeleton.node_count(), 501u);
  EXPECT_EQ(distinct_places(result.skeleton), 5u);
}

TEST(TwoPointTrap, EndsWithTheRepeatGuard) {
  Seedling seedling = two_point_trap(-50.0);
  seedling.growth.variant.repeat_guard = RepeatGuard::on;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(result.stop_reason, StopReason::no_new_node);
  EXPECT_EQ(result.skeleton.node_count(), 5u);
}

TEST(TwoPointTrap, EndsWhenANodeHasAllItsChildren) {
  Seedling seedling = two_point_trap(-50.0);
  seedling.growth.limits.most_children = 3;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(result.stop_reason, StopReason::no_child_allowed);
  EXPECT_EQ(result.passes.size(), 7u);
  EXPECT_EQ(result.skeleton.node_count(), 7u);
  EXPECT_EQ(result.passes.back().refused_children, 1u);
}

TEST(TwoPointTrap, HasNoDirectionExactlyBetweenThePoints) {
  const GrowthResult result = grow(two_point_trap(-45.0));
  EXPECT_EQ(result.stop_reason, StopReason::no_new_node);
  EXPECT_EQ(result.skeleton.positions().back(), (Vector3{0, 0, 0}));
  EXPECT_EQ(result.skeleton.node_count(), 4u);
}

TEST(GrowthLimitsLaw, NoNodeHasMoreChildrenThanAllowed) {
  for (const std::int32_t most : {1, 2, 3}) {
    Seedling seedling = disc_scene(3);
    const std::int32_t without = most_children(grow(seedling).skeleton);
    seedling.growth.limits.most_children = most;
    const GrowthResult result = grow(seedling);
    EXPECT_EQ(most_children(result.skeleton), std::min(most, without));
    if (most < without) {
      EXPECT_EQ(result.stop_reason, StopReason::no_child_allowed) << most;
    }
  }
}

TEST(GrowthLimitsLaw, NoNodeIsDeeperThanAllowed) {
  Seedling seedling = disc_scene(4);
  const std::int32_t without = deepest_branch(grow(seedling).skeleton);
  ASSERT_GE(without, 2);
  for (std::int32_t most = 0; most <= without + 1; ++most) {
    seedling.growth.limits.most_branch_depth = most;
    EXPECT_EQ(deepest_branch(grow(seedling).skeleton), std::min(most, without));
  }
}

TEST(GrowthLimitsLaw, DepthZeroOfAllIsABranchThatNeverForks) {
  Seedling seedling = disc_scene(5);
  seedling.growth.limits.most_branch_depth = 0;
  Seedling one_child = disc_scene(5);
  one_child.growth.limits.most_children = 1;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(tree_hash(result.skeleton), tree_hash(grow(one_child).skeleton));
  EXPECT_EQ(tip_count(result.skeleton), 1u);
}

// A node that may not grow keeps its points: nobody else comes to them but by coming nearer.
TEST(GrowthLimits, ARefusedNodeKeepsItsPoints) {
  // The root grows towards the two points above; the one below is nearest to the root.
  Seedling seedling = flat_scene({{0, 60, 0}, {0, 61, 0}, {0, -30, 0}}, {}, 1);
  seedling.growth.limits.most_children = 1;
  ASSERT_EQ(grow(seedling).skeleton.positions().back(), (Vector3{0, 15, 0}));
  seedling.growth.iterations = 20;
  const GrowthResult result = grow(seedling);
  EXPECT_EQ(result.live_points, 1u);
  EXPECT_EQ(result.stop_reason, StopReason::no_child_allowed);
  EXPECT_EQ(result.passes.back().refused_children, 1u);
  seedling.growth.limits.most_children = 2;
  EXPECT_EQ(grow(seedling).stop_reason, StopReason::no_points_left);
}

TEST(GrowthLimits, CountTheStemInsideTheCrownAsAChild) {
  Seedling seedling = flat_scene({{-60, 0, 0}}, {}, 1);
  seedling.skeleton.append(0, {15, 0, 0});
  seedling.growth.limits.most_children = 1;
  EXPECT_EQ(grow(seedling).stop_reason, StopReason::no_child_allowed);
  seedling.growth.limits.most_children = 2;
  EXPECT_EQ(grow(seedling).skeleton.node_count(), 3u);
}

/// Length of the edges that end at a child of a node with branch depth Z, for each Z.
std::map<std::int32_t, std::set<std::int64_t>> steps_in_hundredths(const Skeleton& tree) {
  const auto depths = branch_depths(tree, BranchDepthReading::at_creation);
  std::map<std::int32_t, std::set<std::int64_t>> steps;
  for (std::size_t i = 1; i < tree.node_count(); ++i) {
    const std::int32_t parent = tree.parents()[i];
    const double length = norm(tree.positions()[i] - tree.position(parent));
    steps[depths[static_cast<std::size_t>(parent)]].insert(std::llround(100.0 * length));
  }
  return steps;
}

TEST(WeightedGrowth, HasStepsFromTwiceTheLengthDownToOnce) {
  Seedling seedling = disc_scene(6);
  seedling.growth.limits.step_weighting = StepWeighting::by_branch_depth;
  seedling.growth.step_length = 9.0;
  seedling.growth.limits.most_branch_depth = 2;
  EXPECT_EQ(steps_in_hundredths(grow(seedling).skeleton),
            (std::map<std::int32_t, std::set<std::int64_t>>{{0, {1800}}, {1, {1350}}, {2, {900}}}));
}

TEST(BranchingLimits, GiveTheStepOfEveryDepth) {
  GrowthParameters parameters;
  parameters.step_length = 15.0;
  parameters.limits.step_weighting = StepWeighting::by_branch_depth;
  // Each node of this comb gets a child that keeps its depth and one that is a level deeper.
  Skeleton comb{Vector3{}};
  std::vector<std::int32_t> of_depth{0};
  for (int depth = 0; depth < 4; ++depth) {
    comb.append(of_depth.back(), {1, 0, 0});
    of_depth.push_back(comb.append(of_depth.back(), {0, 1, 0}));
  }
  const auto steps = [&](std::int32_t most) {
    parameters.limits.most_branch_depth = most;
    BranchingLimits limits(parameters);
    limits.follow(comb);
    std::vector<double> found;
    for (std::int32_t depth = 0; depth <= most; ++depth)
      found.push_back(limits.step_length(of_depth[static_cast<std::size_t>(depth)]));
    return found;
  };
  EXPECT_EQ(steps(4), (std::vector<double>{30, 26.25, 22.5, 18.75, 15}));
  EXPECT_EQ(steps(1), (std::vector<double>{30, 15}));
}

TEST(BranchingLimits, RefuseWeightsThatDivideByNothing) {
  GrowthParameters parameters;
  parameters.limits.step_weighting = StepWeighting::by_branch_depth;
  EXPECT_THROW(BranchingLimits{parameters}, ContractViolation);
  parameters.limits.most_branch_depth = 0;
  EXPECT_THROW(BranchingLimits{parameters}, ContractViolation);
  parameters.limits = {.most_children = 0};
  EXPECT_THROW(BranchingLimits{parameters}, ContractViolation);
}

}  // namespace
}  // namespace phytobench
