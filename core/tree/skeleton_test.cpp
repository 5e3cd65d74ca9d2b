// SPDX-License-Identifier: MIT
#include "core/tree/skeleton.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Root, a trunk of two edges, and two branches of one and two edges:
///
///   5
///   |
///   4   3
///    \ /
///     2
///     |
///     1
///     |
///     0
Skeleton forked(const Vector3& third = {1, 3, 0}, std::int32_t parent_of_last = 4) {
  Skeleton skeleton{Vector3{0, 0, 0}};
  skeleton.append(0, {0, 1, 0});
  skeleton.append(1, {0, 2, 0});
  skeleton.append(2, third);
  skeleton.append(2, {-1, 3, 0});
  skeleton.append(parent_of_last, {-1, 4, 0});
  return skeleton;
}

TEST(Skeleton, StartsWithItsRoot) {
  const Skeleton skeleton{Vector3{1, 2, 3}};
  EXPECT_EQ(skeleton.node_count(), 1u);
  EXPECT_EQ(skeleton.edge_count(), 0u);
  EXPECT_EQ(skeleton.position(0), (Vector3{1, 2, 3}));
  EXPECT_EQ(skeleton.parents()[0], Skeleton::no_parent);
}

TEST(Skeleton, AppendReturnsTheNewIndex) {
  Skeleton skeleton{Vector3{}};
  EXPECT_EQ(skeleton.append(0, {0, 1, 0}), 1);
  EXPECT_EQ(skeleton.append(0, {0, 2, 0}), 2);
  EXPECT_EQ(skeleton.append(2, {0, 3, 0}), 3);
  EXPECT_EQ(skeleton.node_count(), 4u);
  EXPECT_THAT(skeleton.parents(), testing::ElementsAre(Skeleton::no_parent, 0, 0, 2));
  EXPECT_EQ(skeleton.position(3), (Vector3{0, 3, 0}));
}

TEST(Skeleton, RefusesParentsThatDoNotExist) {
  Skeleton skeleton{Vector3{}};
  EXPECT_THROW(skeleton.append(1, {0, 1, 0}), ContractViolation);
  EXPECT_THROW(skeleton.append(Skeleton::no_parent, {0, 1, 0}), ContractViolation);
  EXPECT_THROW(skeleton.append(-2, {0, 1, 0}), ContractViolation);
  EXPECT_EQ(skeleton.node_count(), 1u);
}

TEST(Skeleton, RefusesPositionsThatAreNotFinite) {
  Skeleton skeleton{Vector3{}};
  EXPECT_THROW(skeleton.append(0, {not_a_number, 1, 0}), ContractViolation);
  EXPECT_THROW(skeleton.append(0, {0, infinity, 0}), ContractViolation);
  EXPECT_THROW(skeleton.append(0, {0, 1, -infinity}), ContractViolation);
  EXPECT_EQ(skeleton.node_count(), 1u);
  EXPECT_THROW(Skeleton(Vector3{0, not_a_number, 0}), ContractViolation);
}

TEST(Skeleton, KnowsTheChildrenOfEachNodeByTheirPlace) {
  const Skeleton skeleton = forked();
  EXPECT_TRUE(skeleton.has_child_at(2, {1, 3, 0}));
  EXPECT_TRUE(skeleton.has_child_at(2, {-1, 3, 0}));
  EXPECT_TRUE(skeleton.has_child_at(0, {0, 1, 0}));
  // A node itself, a grandchild, a child of another node and a tip have no such child.
  EXPECT_FALSE(skeleton.has_child_at(0, {0, 0, 0}));
  EXPECT_FALSE(skeleton.has_child_at(0, {0, 2, 0}));
  EXPECT_FALSE(skeleton.has_child_at(1, {1, 3, 0}));
  EXPECT_FALSE(skeleton.has_child_at(5, {-1, 4, 0}));
}

TEST(Skeleton, ChildAlmostAtAPlaceIsNotThere) {
  const Skeleton skeleton = forked();
  EXPECT_FALSE(skeleton.has_child_at(2, {std::nextafter(1.0, 2.0), 3, 0}));
  EXPECT_FALSE(skeleton.has_child_at(2, {1, std::nextafter(3.0, 2.0), 0}));
  EXPECT_FALSE(skeleton.has_child_at(2, {1, 3, std::nextafter(0.0, 1.0)}));
}

TEST(Skeleton, FindsEachOfManyChildren) {
  Skeleton skeleton{Vector3{}};
  for (int i = 1; i <= 50; ++i) skeleton.append(0, {0.0, 1.0 * i, 0.0});
  for (int i = 1; i <= 50; ++i) EXPECT_TRUE(skeleton.has_child_at(0, {0.0, 1.0 * i, 0.0})) << i;
  EXPECT_FALSE(skeleton.has_child_at(0, {0, 51, 0}));
}

TEST(TipCount, CountsNodesWithoutChildren) {
  EXPECT_EQ(tip_count(Skeleton{Vector3{}}), 0u);
  Skeleton skeleton{Vector3{}};
  skeleton.append(0, {0, 1, 0});
  EXPECT_EQ(tip_count(skeleton), 1u);
  skeleton.append(1, {0, 2, 0});
  EXPECT_EQ(tip_count(skeleton), 1u);
  EXPECT_EQ(tip_count(forked()), 2u);
}

TEST(EdgeDepth, IsTheLongestPathFromTheRoot) {
  EXPECT_EQ(edge_depth(Skeleton{Vector3{}}), 0u);
  EXPECT_EQ(edge_depth(forked()), 4u);
  EXPECT_EQ(edge_depth(forked({1, 3, 0}, 0)), 3u);
}

TEST(HighestY, IsThatOfAnyNode) {
  EXPECT_EQ(highest_y(Skeleton{Vector3{5, -3, 5}}), -3.0);
  EXPECT_EQ(highest_y(forked()), 4.0);
  EXPECT_EQ(highest_y(forked({1, 30, 0})), 30.0);
}

TEST(TreeHash, OfARootIsThePublishedFunction) {
  // 64-bit FNV-1a over 24 zero bytes (a root at the origin) and 8 bytes ff (parent -1).
  EXPECT_EQ(tree_hash(Skeleton{Vector3{}}), "27527c50b012d01d");
}

TEST(TreeHash, IsSixteenHexadecimalDigits) {
  const std::string hash = tree_hash(forked());
  EXPECT_EQ(hash.size(), 16u);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos) << hash;
  EXPECT_EQ(hash, tree_hash(forked()));
}

TEST(TreeHash, ChangesWithOneBitOrOneParent) {
  std::set<std::string> hashes{
      tree_hash(forked()),
      tree_hash(forked({std::nextafter(1.0, 2.0), 3, 0})),
      tree_hash(forked({1, std::nextafter(3.0, 2.0), 0})),
      tree_hash(forked({1, 3, std::nextafter(0.0, 1.0)})),
      tree_hash(forked({1, 3, -0.0})),
      tree_hash(forked({1, 3, 0}, 3)),
      tree_hash(forked({3, 1, 0})),
  };
  EXPECT_EQ(hashes.size(), 7u);
}

TEST(TreeHash, ChangesWithTheOrderOfNodes) {
  Skeleton one{Vector3{}}, other{Vector3{}};
  one.append(0, {1, 0, 0});
  one.append(0, {2, 0, 0});
  other.append(0, {2, 0, 0});
  other.append(0, {1, 0, 0});
  EXPECT_NE(tree_hash(one), tree_hash(other));
}

TEST(SkeletonLaw, MovingTheTreeKeepsItsShape) {
  const Skeleton tree = forked();
  Skeleton moved{tree.position(0) + Vector3{8, 16, 32}};
  for (std::size_t i = 1; i < tree.node_count(); ++i)
    moved.append(tree.parents()[i], tree.positions()[i] + Vector3{8, 16, 32});
  EXPECT_EQ(tip_count(moved), tip_count(tree));
  EXPECT_EQ(edge_depth(moved), edge_depth(tree));
  EXPECT_EQ(highest_y(moved), highest_y(tree) + 16.0);
  EXPECT_NE(tree_hash(moved), tree_hash(tree));
}

}  // namespace
}  // namespace phytobench
