// SPDX-License-Identifier: MIT
#include "core/tree/recursive_tree.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

/// A size limit such that segments of level k are the first that are too small.
RecursiveTreeParameters of_levels(std::int32_t branches, int levels) {
  return {.smallest = std::pow(0.5, levels - 0.5),
          .branches = branches,
          .stem_ratio = 0.5,
          .branch_ratio = 0.5};
}

TEST(RecursiveTreeLaw, HasAsManySegmentsAndLeavesAsTheListingSays) {
  for (int n = 1; n <= 4; ++n)
    for (int k = 0; k <= 5; ++k) {
      const RecursiveTree tree = grow_recursive_tree(of_levels(n, k));
      const auto leaves = static_cast<std::size_t>(std::lround(std::pow(n + 1, k)));
      EXPECT_EQ(tree.leaf_nodes.size(), leaves) << n << " " << k;
      EXPECT_EQ(tree.skeleton.edge_count(),
                (leaves * static_cast<std::size_t>(n + 1) - 1) / static_cast<std::size_t>(n));
    }
}

TEST(RecursiveTreeLaw, LeavesAreAtTheTipsAndNowhereElse) {
  const RecursiveTree tree = grow_recursive_tree({.branches = 3});
  const ChildLists children(tree.skeleton);
  EXPECT_EQ(tree.leaf_nodes.size(), tip_count(tree.skeleton));
  for (const std::int32_t node : tree.leaf_nodes) EXPECT_TRUE(children.of(node).empty());
}

TEST(RecursiveTree, ShrinksAndTurnsItsBranches) {
  const RecursiveTree tree = grow_recursive_tree({.smallest = 0.9,
                                                  .branches = 1,
                                                  .stem_ratio = 0.8,
                                                  .branch_ratio = 0.5,
                                                  .branch_angle_deg = 90.0,
                                                  .twist_deg = 0.0});
  ASSERT_EQ(tree.skeleton.node_count(), 4u);
  EXPECT_EQ(tree.skeleton.positions()[1], (Vector3{0, 1, 0}));
  EXPECT_LE(norm(tree.skeleton.positions()[2] - Vector3{0, 1.8, 0}), 1e-15);
  EXPECT_LE(norm(tree.skeleton.positions()[3] - Vector3{-0.5, 1, 0}), 1e-15);
}

TEST(RecursiveTree, WithoutBranchesIsAStem) {
  EXPECT_EQ(grow_recursive_tree({.branches = 0}).leaf_nodes.size(), 1u);
}

TEST(RecursiveTree, RefusesWhatHasNoEndOrNoMeaning) {
  EXPECT_THROW(grow_recursive_tree({.size = 0.0}), InputError);
  EXPECT_THROW(grow_recursive_tree({.smallest = 0.0}), InputError);
  EXPECT_THROW(grow_recursive_tree({.branches = -1}), InputError);
  EXPECT_THROW(grow_recursive_tree({.stem_ratio = 1.0}), InputError);
  EXPECT_THROW(grow_recursive_tree({.branch_ratio = 0.0}), InputError);
  EXPECT_THROW(grow_recursive_tree({.branch_angle_deg = NAN}), InputError);
  EXPECT_THROW(grow_recursive_tree({.smallest = 1e-9, .branches = 50, .most_segments = 1000}),
               InputError);
}

}  // namespace
}  // namespace phytobench
