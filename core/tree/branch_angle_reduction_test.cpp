// SPDX-License-Identifier: MIT
#include "core/tree/branch_angle_reduction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// A stem of length 1 with two branches of length 1 at this angle between them.
Skeleton fork(double angle_rad) {
  Skeleton tree{Vector3{}};
  const std::int32_t top = tree.append(0, {0, 1, 0});
  const double half = 0.5 * angle_rad;
  for (const double side : {-1.0, 1.0})
    tree.append(top, {side * std::sin(half), 1.0 + std::cos(half), 0});
  return tree;
}

double fork_angle(const Skeleton& tree) {
  const Vector3 a = tree.positions()[2] - tree.positions()[1];
  const Vector3 b = tree.positions()[3] - tree.positions()[1];
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

// Halfway the branches become the mean of themselves and the stem: of unit edges half the angle.
TEST(BranchAngleReduction, HalfwayHalvesTheAngleBetweenEqualEdges) {
  constexpr double rounding = 1e-14;
  for (const double angle : {0.2, 1.0, 2.0, 3.0})
    EXPECT_NEAR(fork_angle(reduce_branch_angles(fork(angle), 0.5)), 0.5 * angle, rounding);
}

TEST(BranchAngleReductionLaw, NarrowsAnglesMoreTheLargerTheShare) {
  double last = 1.5;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double angle = fork_angle(reduce_branch_angles(fork(1.5), share));
    EXPECT_LT(angle, last) << share;
    last = angle;
  }
}

TEST(BranchAngleReductionLaw, LeavesRootAndBranchingAlone) {
  const Skeleton tree = fork(1.0), reduced = reduce_branch_angles(tree, 0.5);
  EXPECT_EQ(reduced.positions()[0], tree.positions()[0]);
  EXPECT_EQ(reduced.parents(), tree.parents());
  EXPECT_EQ(reduced.positions()[1], (Vector3{0, 0.5, 0}));
}

TEST(BranchAngleReduction, CountsParentsWhereTheyStoodBefore) {
  Skeleton tree{Vector3{}};
  tree.append(0, {0, 4, 0});
  tree.append(1, {4, 4, 0});
  const Skeleton reduced = reduce_branch_angles(tree, 0.25);
  EXPECT_EQ(reduced.positions()[1], (Vector3{0, 3, 0}));
  EXPECT_EQ(reduced.positions()[2], (Vector3{3, 4, 0}));
}

TEST(BranchAngleReduction, ByNothingChangesNoBit) {
  const Skeleton tree = fork(0.7);
  EXPECT_EQ(tree_hash(reduce_branch_angles(tree, 0.0)), tree_hash(tree));
}

TEST(BranchAngleReduction, RefusesToFoldTheTree) {
  EXPECT_THROW(reduce_branch_angles(fork(1.0), 1.0), ContractViolation);
  EXPECT_THROW(reduce_branch_angles(fork(1.0), -0.1), ContractViolation);
}

}  // namespace
}  // namespace phytobench
