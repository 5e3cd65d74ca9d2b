// SPDX-License-Identifier: MIT
#include "core/tree/leaves.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// A stem with many thin branches of one edge.
Skeleton brush(int branches) {
  Skeleton tree({0, 0, 0});
  for (int i = 0; i < branches; ++i) tree.append(0, {std::cos(i), 0.5, std::sin(i)});
  return tree;
}

std::vector<double> thin(const Skeleton& tree) {
  return std::vector<double>(tree.node_count(), 0.007);
}

bool same(const Leaf& a, const Leaf& b) {
  return a.position == b.position && a.turned == b.turned;
}

TEST(Leaves, GrowOnThinBranchesButNeverOnTheRoot) {
  const Skeleton tree = brush(10);
  std::vector<double> radii = thin(tree);
  for (std::size_t i = 1; i <= 4; ++i) radii[i] = 0.009;
  EXPECT_EQ(leaf_bearing_nodes(tree, radii, 0.009), 6u);
  EXPECT_EQ(make_leaves(tree, radii, {.per_node = 3.0}).size(), 18u);
}

TEST(LeavesLaw, TheFractionIsAProbability) {
  const Skeleton tree = brush(20000);
  for (const double per_node : {0.0, 0.3, 0.7, 1.0, 1.5}) {
    const auto count = static_cast<double>(
        make_leaves(tree, thin(tree), {.per_node = per_node, .seed = 3}).size());
    const double fraction = per_node - std::floor(per_node);
    EXPECT_NEAR(count, 20000 * per_node, 4.0 * std::sqrt(20000 * fraction * (1 - fraction)));
  }
}

TEST(LeavesLaw, AnotherCountNeitherMovesNorTurnsThoseThatStay) {
  const Skeleton tree = brush(200);
  const auto few = make_leaves(tree, thin(tree), {.per_node = 0.6});
  const auto many = make_leaves(tree, thin(tree), {.per_node = 2.7});
  for (const Leaf& leaf : few)
    EXPECT_TRUE(std::any_of(many.begin(), many.end(),
                            [&](const Leaf& other) { return same(leaf, other); }));
}

TEST(LeavesLaw, AnotherSizeKeepsPlaceAndTurn) {
  const Skeleton tree = brush(50);
  const auto small = make_leaves(tree, thin(tree), {.size = 0.1});
  const auto large = make_leaves(tree, thin(tree), {.size = 1.0});
  ASSERT_EQ(small.size(), large.size());
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_TRUE(same(small[i], large[i]));
    EXPECT_NEAR(large[i].size, 10.0 * small[i].size, 1e-12);
  }
}

TEST(LeavesLaw, PlacesAreUniformAlongTheEdge) {
  const Skeleton tree = brush(10000);
  std::vector<double> shares;
  for (const Leaf& leaf : make_leaves(tree, thin(tree), {.per_node = 1.0}))
    shares.push_back(leaf.position.y / 0.5);
  std::sort(shares.begin(), shares.end());
  double distance = 0.0;  // Kolmogorov and Smirnov
  for (std::size_t i = 0; i < shares.size(); ++i)
    distance = std::max(distance, std::abs(shares[i] - (static_cast<double>(i) + 0.5) / 10000));
  EXPECT_LT(distance, 1.63 / std::sqrt(10000.0));  // p = 0.01
}

TEST(LeavesLaw, SizesAreNormal) {
  const Skeleton tree = brush(20000);
  double sum = 0.0, squares = 0.0;
  int beyond_one = 0;
  for (const Leaf& leaf : make_leaves(tree, thin(tree), {.per_node = 1.0, .size = 0.7})) {
    const double z = (leaf.size / 0.7 - 1.0) / 0.2;
    EXPECT_GT(leaf.size, 0.0);
    sum += z;
    squares += z * z;
    beyond_one += std::abs(z) > 1.0;
  }
  EXPECT_NEAR(sum / 20000, 0.0, 4.0 / std::sqrt(20000.0));
  EXPECT_NEAR(squares / 20000, 1.0, 0.04);
  EXPECT_NEAR(beyond_one / 20000.0, 0.3173, 0.015);
}

TEST(LeafMesh, ACrossFoilIsTwoSquaresAtRightAnglesWithTwoSidesEach) {
  const Leaf leaf{{1, 2, 3}, Rotation::about({1, 0, 0}, 0.3), 0.8};
  const TriangleMesh mesh = mesh_leaves(std::vector<Leaf>{leaf}, LeafShape::cross_foil);
  EXPECT_EQ(mesh.vertex_count(), 16u);
  EXPECT_EQ(mesh.triangle_count(), 8u);
  EXPECT_NEAR(dot(mesh.normals[0], mesh.normals[8]), 0.0, 1e-15);
  EXPECT_EQ(mesh.normals[0], -1.0 * mesh.normals[4]);
  Vector3 sum;
  for (const Vector3& p : mesh.positions) sum = sum + p;
  EXPECT_LE(norm(sum / 16.0 - leaf.position), 1e-14);
  EXPECT_NEAR(norm(mesh.positions[1] - mesh.positions[0]), 0.8, 1e-14);
}

TEST(LeafMesh, ASquareHasHalfOfThat) {
  const TriangleMesh mesh = mesh_leaves(std::vector<Leaf>(3, Leaf{{}, {}, 1.0}), LeafShape::square);
  EXPECT_EQ(mesh.vertex_count(), 24u);
  EXPECT_EQ(mesh.triangle_count(), 12u);
}

TEST(LeafMeshLaw, TrianglesFaceWhereTheirNormalsPoint) {
  const Leaf leaf{{0, 0, 0}, Rotation::uniform(0.2, 0.5, 0.9), 1.0};
  const TriangleMesh mesh = mesh_leaves(std::vector<Leaf>{leaf}, LeafShape::cross_foil);
  for (const Triangle& t : mesh.triangles) {
    const Vector3& a = mesh.positions[t[0]];
    const Vector3 normal = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    EXPECT_NEAR(dot(normal / norm(normal), mesh.normals[t[0]]), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace phytobench
