// SPDX-License-Identifier: MIT
#include "core/tree/pendulous_branches.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/tree/branches.hpp"
#include "core/tree/test_angles.hpp"

namespace phytobench {
namespace {

double angle_to_ground_deg(const Skeleton& tree, std::size_t node) {
  const Vector3 edge = tree.positions()[node] - tree.position(tree.parents()[node]);
  return std::acos(std::clamp(-edge.y / norm(edge), -1.0, 1.0)) / degree;
}

/// A straight branch from the top of one vertical edge, at an angle to the ground.
Skeleton straight_branch(double theta_deg, int edges) {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  const Vector3 step{std::sin(theta_deg * degree), -std::cos(theta_deg * degree), 0};
  for (int i = 0; i < edges; ++i) tree.append(i + 1, tree.position(i + 1) + 0.5 * step);
  return tree;
}

TEST(PendulousAngle, IsAParabola) {
  EXPECT_EQ(pendulous_angle(std::numbers::pi, 0.8), 0.0);
  EXPECT_EQ(pendulous_angle(0.0, 0.8), 0.0);
  EXPECT_NEAR(pendulous_angle(120 * degree, 0.8), 32 * degree, 1e-15);
  EXPECT_NEAR(pendulous_angle(60 * degree, 0.8), 32 * degree, 1e-15);
  EXPECT_NEAR(pendulous_angle(90 * degree, 0.8), 36 * degree, 1e-15);
}

// Each edge is first carried along with the branch, then turned by its own angle.
TEST(BendBranches, TurnsAStraightBranchStepByStep) {
  const Skeleton bent =
      bend_branches(straight_branch(120, 7), {.intensity = 0.8, .first_order = 2});
  const double expected[] = {88, 52.018, 22.430, 6.722, 1.545};
  for (std::size_t i = 0; i < std::size(expected); ++i)
    EXPECT_NEAR(angle_to_ground_deg(bent, i + 2), expected[i], 1e-3) << i;
  const Skeleton less =
      bend_branches(straight_branch(120, 7), {.intensity = 0.4, .first_order = 2});
  const double expected_less[] = {104, 86.436, 68.464, 51.494, 36.789};
  for (std::size_t i = 0; i < std::size(expected_less); ++i)
    EXPECT_NEAR(angle_to_ground_deg(less, i + 2), expected_less[i], 1e-3) << i;
}

TEST(BendBranches, LeavesVerticalEdgesAlone) {
  for (const double theta : {0.0, 180.0}) {
    const Skeleton tree = straight_branch(theta, 4);
    const Skeleton bent = bend_branches(tree, {.intensity = 0.8, .first_order = 0});
    for (std::size_t i = 0; i < tree.node_count(); ++i)
      EXPECT_LE(norm(bent.positions()[i] - tree.positions()[i]), 1e-15);
  }
}

TEST(BendBranches, LeavesLowerOrdersAsTheyAreBitForBit) {
  const Skeleton tree = straight_branch(100, 6);
  const Skeleton bent = bend_branches(tree, {.intensity = 0.5, .first_order = 4});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(bent.positions()[i], tree.positions()[i]);
  EXPECT_NE(bent.positions()[4], tree.positions()[4]);
  EXPECT_EQ(bend_branches(tree, {.intensity = 0.0}).positions(), tree.positions());
}

TEST(BendBranchesLaw, KeepsEdgeLengthsAndParents) {
  Skeleton tree = straight_branch(110, 30);
  for (std::int32_t i = 3; i < 25; i += 3)
    tree.append(i, tree.position(i) + Vector3{0.2, 0.3, 0.4});
  const Skeleton bent = bend_branches(tree, {.intensity = 0.9, .first_order = 3});
  EXPECT_EQ(bent.parents(), tree.parents());
  for (std::size_t i = 1; i < tree.node_count(); ++i) {
    const auto length = [i](const Skeleton& s) {
      return norm(s.positions()[i] - s.position(s.parents()[i]));
    };
    EXPECT_NEAR(length(bent), length(tree), 1e-12);
  }
}

TEST(BendBranchesLaw, NeverTurnsAnEdgePastTheGround) {
  for (double theta = 0.0; theta <= 180.0; theta += 7.5)
    for (const double lambda : {0.1, 0.5, 1.0}) {
      const Skeleton bent =
          bend_branches(straight_branch(theta, 1), {.intensity = lambda, .first_order = 2});
      EXPECT_LE(angle_to_ground_deg(bent, 2), theta + 1e-6);
      EXPECT_GE(bent.positions()[2].x, -1e-12);
    }
}

TEST(BendBranches, ASecondTimeBendsFurther) {
  const PendulousBranches pendulous{.intensity = 0.5, .first_order = 2};
  const Skeleton once = bend_branches(straight_branch(120, 5), pendulous);
  const Skeleton twice = bend_branches(once, pendulous);
  EXPECT_LT(twice.positions().back().y, once.positions().back().y - 1e-3);
}

}  // namespace
}  // namespace phytobench
