// SPDX-License-Identifier: MIT
#include "core/tree/branches.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;

/// 0 - 1 - 2 - 3, with 4 and 5 on 1 and 6 on 4.
Skeleton three_way_fork() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  tree.append(1, {0, 2, 0});
  tree.append(2, {0, 3, 0});
  tree.append(1, {1, 2, 0});
  tree.append(1, {-1, 2, 0});
  tree.append(4, {2, 2, 0});
  return tree;
}

Skeleton random_tree_in_plane(int nodes) {
  CounterStream stream(5, 0);
  Skeleton tree({0, 0, 0});
  for (int i = 1; i < nodes; ++i) {
    const auto parent = static_cast<std::int32_t>(stream.next_unit() * i);
    tree.append(parent, tree.position(parent) + Vector3{stream.next_unit(), stream.next_unit(), 0});
  }
  return tree;
}

TEST(ChildLists, NameChildrenAscending) {
  const Skeleton tree = three_way_fork();
  const ChildLists children(tree);
  EXPECT_THAT(children.of(0), ElementsAre(1));
  EXPECT_THAT(children.of(1), ElementsAre(2, 4, 5));
  EXPECT_TRUE(children.of(3).empty());
  EXPECT_TRUE(ChildLists(Skeleton({0, 0, 0})).of(0).empty());
}

TEST(TipsAbove, CountsTipsAndATipItself) {
  EXPECT_THAT(tips_above(three_way_fork()), ElementsAre(3, 3, 1, 1, 1, 1, 1));
  EXPECT_THAT(tips_above(Skeleton({0, 0, 0})), ElementsAre(1));
}

TEST(NodeDepths, CountEdgesFromTheRoot) {
  EXPECT_THAT(node_depths(three_way_fork()), ElementsAre(0, 1, 2, 3, 2, 2, 3));
}

TEST(BranchOrders, FollowTheThickestChild) {
  const Skeleton tree = three_way_fork();
  EXPECT_THAT(branch_orders(tree, branch_radii(tree, 1, 2)), ElementsAre(0, 0, 0, 0, 1, 1, 1));
  const std::vector<double> radii{3, 3, 1, 1, 2, 1, 2};
  EXPECT_THAT(branch_orders(tree, radii), ElementsAre(0, 0, 1, 1, 0, 1, 0));
}

TEST(BranchRadii, FollowThePowerSumRule) {
  const Skeleton tree = three_way_fork();
  const std::vector<double> radii = branch_radii(tree, 0.5, 2.0);
  EXPECT_DOUBLE_EQ(radii[3], 0.5);
  EXPECT_DOUBLE_EQ(radii[2], 0.5);
  EXPECT_DOUBLE_EQ(radii[1], 0.5 * std::sqrt(3.0));
  EXPECT_EQ(radii[0], radii[1]);
}

TEST(BranchRadiiLaw, EveryBranchingHoldsForAnyExponent) {
  const Skeleton tree = random_tree_in_plane(500);
  const ChildLists children(tree);
  for (const double exponent : {1.0, 1.9, 2.0, 3.0}) {
    const std::vector<double> radii = branch_radii(tree, 0.007, exponent);
    for (std::size_t node = 0; node < tree.node_count(); ++node) {
      const auto above = children.of(static_cast<std::int32_t>(node));
      double sum = 0.0;
      for (const std::int32_t child : above) {
        sum += std::pow(radii[static_cast<std::size_t>(child)], exponent);
        EXPECT_LE(radii[static_cast<std::size_t>(child)], radii[node]);
      }
      const double expected = above.empty() ? 0.007 : std::pow(sum, 1.0 / exponent);
      EXPECT_NEAR(radii[node], expected, 1e-12 * expected);
    }
  }
}

}  // namespace
}  // namespace phytobench
