// SPDX-License-Identifier: MIT
#include "core/tree/habit.hpp"

#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/geometry/rotation.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

/// A stem 0 - 1, a straight axis 1 - 2 - 3 - 4, and on 2 a side branch 5 - 6 that turns upwards.
Skeleton tree_with_side_branch() {
  Skeleton tree({0, 0, 0});
  for (int y = 1; y <= 4; ++y) tree.append(y - 1, {0, static_cast<double>(y), 0});
  tree.append(2, {1, 2, 0});
  tree.append(5, {1, 3, 0});
  return tree;
}

Skeleton random_tree_in_space(int nodes) {
  CounterStream stream(11, 0);
  Skeleton tree({0, 0, 0});
  for (int i = 1; i < nodes; ++i) {
    const auto parent = static_cast<std::int32_t>(stream.next_unit() * i);
    const double x = stream.next_between(-1, 1), y = stream.next_between(-1, 1);
    tree.append(parent, tree.position(parent) + Vector3{x, y, stream.next_between(-1, 1)});
  }
  return tree;
}

Skeleton turned(const Skeleton& tree, const Rotation& rotation) {
  Skeleton result(rotation(tree.positions()[0]));
  for (std::size_t i = 1; i < tree.node_count(); ++i)
    result.append(tree.parents()[i], rotation(tree.positions()[i]));
  return result;
}

TEST(BranchingCount, CountsNodesNotChildren) {
  EXPECT_EQ(branching_count(tree_with_side_branch()), 1u);
  Skeleton tree = tree_with_side_branch();
  tree.append(2, {-1, 2, 0});
  EXPECT_EQ(branching_count(tree), 1u) << "three children are one branching";
  tree.append(5, {2, 3, 0});
  EXPECT_EQ(branching_count(tree), 2u);
  EXPECT_EQ(branching_count(Skeleton({0, 0, 0})), 0u);
}

TEST(MeanTurn, LooksAtUnbranchedStretchesOnly) {
  // 1 goes on straight, 3 goes on straight, 5 turns by a right angle; 2 branches.
  EXPECT_NEAR(mean_turn_rad(tree_with_side_branch(), 0), right_angle / 3, 1e-12);
  EXPECT_NEAR(mean_turn_rad(tree_with_side_branch(), 3), right_angle / 2, 1e-12)
      << "without the stem";
  EXPECT_EQ(mean_turn_rad(Skeleton({0, 0, 0}), 0), 0.0);
}

TEST(MeanTurnLaw, IsKeptByRotations) {
  const Skeleton tree = random_tree_in_space(300);
  const Rotation rotation = Rotation::about({0, 0, 1}, 0.7);
  EXPECT_NEAR(mean_turn_rad(turned(tree, rotation), 0), mean_turn_rad(tree, 0), 1e-9);
}

TEST(TrunkShare, ComparesAreasAtAHeight) {
  const Skeleton tree = tree_with_side_branch();
  const std::vector<double> radii{2, 2, 2, 2, 1, 1, 1};
  EXPECT_EQ(trunk_share(tree, radii, 0.5), 1.0) << "the stem alone";
  EXPECT_EQ(trunk_share(tree, radii, 2.5), 0.8) << "2^2 of 2^2 + 1^2";
  EXPECT_EQ(trunk_share(tree, radii, 9.0), 0.0) << "above the tree";
}

TEST(TrunkShareLaw, EqualBranchesShareEqually) {
  Skeleton tree({0, 0, 0});
  for (int i = 0; i < 8; ++i) tree.append(0, {static_cast<double>(i), 1, 0});
  EXPECT_DOUBLE_EQ(trunk_share(tree, branch_radii(tree, 0.1, 2), 0.5), 1.0 / 8);
}

TEST(CrownParts, GoFromTheInsideToTheOutside) {
  const std::vector<CrownPart> parts = crown_parts(tree_with_side_branch(), 1, 2);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].inner_nodes, 2u) << "nodes 1 and 2";
  EXPECT_EQ(parts[0].branchings, 1u);
  EXPECT_EQ(parts[0].branching_share(), 0.5);
  EXPECT_EQ(parts[1].inner_nodes, 2u) << "3 and 5; the tips count nowhere";
  EXPECT_EQ(parts[1].branching_share(), 0.0);
  EXPECT_EQ(crown_parts(Skeleton({0, 0, 0}), 0, 3)[2].branching_share(), 0.0);
}

TEST(CrownPartsLaw, TogetherHoldEveryInnerNodeAndBranching) {
  const Skeleton tree = random_tree_in_space(500);
  for (const std::size_t parts : {1u, 2u, 7u}) {
    std::size_t inner = 0, branchings = 0;
    for (const CrownPart& part : crown_parts(tree, 0, parts)) {
      inner += part.inner_nodes;
      branchings += part.branchings;
    }
    EXPECT_EQ(branchings, branching_count(tree));
    EXPECT_EQ(inner, tree.node_count() - tip_count(tree));
  }
}

TEST(Habit, WrongCallsAreRefused) {
  const Skeleton tree = tree_with_side_branch();
  EXPECT_THROW(trunk_share(tree, std::vector<double>{1.0}, 0.5), ContractViolation);
  EXPECT_THROW(crown_parts(tree, 7, 2), ContractViolation);
  EXPECT_THROW(crown_parts(tree, 0, 0), ContractViolation);
  EXPECT_THROW(crown_parts(tree, 4, 2), ContractViolation) << "node 5 does not grow on node 4";
}

}  // namespace
}  // namespace phytobench
