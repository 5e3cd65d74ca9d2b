// SPDX-License-Identifier: MIT
#include "core/tree/branch_depth.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

using enum BranchDepthReading;
using Histogram = std::map<std::int32_t, std::int64_t>;

/// The graph of [Liebemann2017] eq. 2.17: A becomes F with three branches F A. Positions do not
/// matter here.
void expand(Skeleton& tree, std::int32_t node, int steps) {
  if (steps == 0) return;
  const std::int32_t trunk = tree.append(node, tree.position(node) + Vector3{0, 1, 0});
  for (int branch = 0; branch < 3; ++branch)
    expand(tree, tree.append(trunk, tree.position(trunk) + Vector3{1, 0, 0}), steps - 1);
}

Skeleton tree_of_equation_2_17(int steps) {
  Skeleton tree{Vector3{}};
  expand(tree, 0, steps);
  return tree;
}

Skeleton random_tree_on_a_line(std::uint64_t seed) {
  CounterStream stream(seed, 0);
  Skeleton tree{Vector3{}};
  for (std::int32_t i = 1; i < 400; ++i) {
    const auto parent = static_cast<std::int32_t>(stream.next_unit() * i);
    tree.append(stream.next_unit() < 0.6 ? i - 1 : parent, {stream.next_unit(), 0, 0});
  }
  return tree;
}

Histogram histogram(const std::vector<std::int32_t>& depths) {
  Histogram counts;
  for (const std::int32_t depth : depths) ++counts[depth];
  return counts;
}

Histogram histogram_of_tips(const Skeleton& tree, const std::vector<std::int32_t>& depths) {
  const ChildLists children(tree);
  Histogram counts;
  for (std::size_t i = 0; i < depths.size(); ++i)
    if (children.of(static_cast<std::int32_t>(i)).empty()) ++counts[depths[i]];
  return counts;
}

TEST(BranchDepth, AtCreationTheFirstChildGoesOnAndLaterOnesAreDeeper) {
  Skeleton tree{Vector3{}};
  tree.append(0, {0, 1, 0});
  tree.append(1, {0, 2, 0});
  tree.append(1, {1, 2, 0});
  tree.append(3, {1, 3, 0});
  tree.append(3, {2, 3, 0});
  EXPECT_EQ(branch_depths(tree, at_creation), (std::vector<std::int32_t>{0, 0, 0, 1, 1, 2}));
  EXPECT_EQ(branch_depths(tree, finished_tree), (std::vector<std::int32_t>{0, 0, 1, 1, 2, 2}));
}

TEST(BranchDepth, OfARootAloneIsZero) {
  const Skeleton tree{Vector3{}};
  EXPECT_EQ(branch_depths(tree, at_creation), std::vector<std::int32_t>{0});
  EXPECT_EQ(branch_depths(tree, finished_tree), std::vector<std::int32_t>{0});
}

// Per fork one child of three keeps the depth: (1 + 2 x)^8 for the tips.
TEST(BranchDepth, AtCreationOfEquation217HasBinomialTips) {
  const Skeleton tree = tree_of_equation_2_17(8);
  ASSERT_EQ(tree.node_count(), 13121u);
  const auto depths = branch_depths(tree, at_creation);
  EXPECT_EQ(histogram_of_tips(tree, depths), (Histogram{{0, 1},
                                                        {1, 16},
                                                        {2, 112},
                                                        {3, 448},
                                                        {4, 1120},
                                                        {5, 1792},
                                                        {6, 1792},
                                                        {7, 1024},
                                                        {8, 256}}));
  EXPECT_EQ(histogram(depths), (Histogram{{0, 17},
                                          {1, 128},
                                          {2, 560},
                                          {3, 1568},
                                          {4, 2912},
                                          {5, 3584},
                                          {6, 2816},
                                          {7, 1280},
                                          {8, 256}}));
}

TEST(BranchDepth, OnTheFinishedTreeOfEquation217HasPowersOfThree) {
  EXPECT_EQ(
      histogram(branch_depths(tree_of_equation_2_17(8), finished_tree)),
      (Histogram{
          {0, 2}, {1, 6}, {2, 18}, {3, 54}, {4, 162}, {5, 486}, {6, 1458}, {7, 4374}, {8, 6561}}));
}

TEST(BranchDepthLaw, IsNeverAboveTheNodeDepthNorAboveTheOtherReading) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Skeleton tree = random_tree_on_a_line(seed);
    const auto edges = node_depths(tree);
    const auto created = branch_depths(tree, at_creation);
    const auto finished = branch_depths(tree, finished_tree);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ASSERT_LE(created[i], finished[i]);
      ASSERT_LE(finished[i], edges[i]);
    }
  }
}

// An edge in two pieces has a node more, and no branch is any deeper for it.
TEST(BranchDepthLaw, DoesNotCountTheNodesOfACurve) {
  for (const BranchDepthReading reading : {at_creation, finished_tree}) {
    const Skeleton tree = random_tree_on_a_line(3);
    const auto depths = branch_depths(tree, reading);
    Skeleton finer{tree.positions()[0]};
    std::vector<std::int32_t> same{0};  // per node of the tree its number in the finer one
    for (std::size_t i = 1; i < tree.node_count(); ++i) {
      const std::int32_t parent = same[static_cast<std::size_t>(tree.parents()[i])];
      same.push_back(finer.append(finer.append(parent, {0.5, 0, 0}), tree.positions()[i]));
    }
    const auto finer_depths = branch_depths(finer, reading);
    for (std::size_t i = 0; i < depths.size(); ++i)
      ASSERT_EQ(finer_depths[static_cast<std::size_t>(same[i])], depths[i]) << "node " << i;
  }
}

TEST(BranchDepthLaw, OfAGrowingTreeIsThatAtCreation) {
  const Skeleton tree = random_tree_on_a_line(5);
  const auto expected = branch_depths(tree, at_creation);
  BranchDepths growing;
  for (std::size_t i = 0; i < tree.node_count(); ++i) {
    if (i > 0) {
      EXPECT_EQ(growing.depth_of_next_child(tree.parents()[i]), expected[i]);
    }
    growing.append(tree.parents()[i]);
  }
  EXPECT_EQ(growing.depths(), expected);
  const ChildLists children(tree);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(tree.node_count()); ++i)
    EXPECT_EQ(growing.children(i), static_cast<std::int32_t>(children.of(i).size()));
}

TEST(BranchDepth, RefusesAParentThatIsNotThere) {
  BranchDepths depths;
  EXPECT_THROW(depths.append(0), ContractViolation);
  depths.append(Skeleton::no_parent);
  EXPECT_THROW(depths.append(Skeleton::no_parent), ContractViolation);
  EXPECT_THROW(depths.append(1), ContractViolation);
  EXPECT_THROW(depths.append(-2), ContractViolation);
}

}  // namespace
}  // namespace phytobench
