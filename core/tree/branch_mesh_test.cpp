// SPDX-License-Identifier: MIT
#include "core/tree/branch_mesh.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/colonization/tree_parameters.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/mesh_measures.hpp"

namespace phytobench {
namespace {

Skeleton chain(int edges) {
  Skeleton tree({0, 0, 0});
  for (int i = 0; i < edges; ++i) tree.append(i, {0.1 * i, i + 1.0, 0.05 * i});
  return tree;
}

Skeleton grown_tree() {
  TreeParameters parameters;
  parameters.cloud.radii = {2.5, 3.5, 2.0};
  const auto engine = engine_named("node_driven").create();
  return grow_crown(make_seedling(parameters), *engine).skeleton;
}

/// A branch that hangs down from a stem and tilts first to one side, then to another: turned from
/// the vertical its rings twist, since the smallest rotation to straight down has no axis.
Skeleton hanging_tree() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  tree.append(1, {0.5, 1.2, 0});
  tree.append(2, {0.9, 1.0, 0});
  for (std::int32_t i = 3; i < 9; ++i)
    tree.append(i, tree.position(i) + (i < 6 ? Vector3{0.05, -0.5, 0} : Vector3{0, -0.5, 0.05}));
  return tree;
}

TEST(Ring, IsARegularPolygonAboutItsCenter) {
  const Vector3 center{1, 2, 3}, normal = Vector3{1, 2, -2} / 3.0;
  for (int w = 3; w <= 64; ++w) {
    const auto points = ring(center, 0.5, Rotation::between({0, 1, 0}, normal), w);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(w));
    Vector3 sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(norm(points[i] - center), 0.5, 1e-14);
      EXPECT_NEAR(dot(points[i] - center, normal), 0.0, 1e-14);
      EXPECT_NEAR(norm(points[(i + 1) % points.size()] - points[i]), std::sin(std::numbers::pi / w),
                  1e-14);
      sum = sum + (points[i] - center);
    }
    EXPECT_LE(norm(sum), 1e-13);
  }
}

TEST(MeshBranches, CountsAsTheAppendixDoes) {
  const Skeleton tree = grown_tree();
  for (const double exponent : {1.3, 1.9, 3.0})
    for (const int w : {3, 6, 7}) {
      const std::vector<double> radii = branch_radii(tree, 0.007, exponent);
      std::size_t duplicates = 0;
      for (std::size_t i = 1; i < tree.node_count(); ++i)
        duplicates += radii[i] <= 0.49 * radii[static_cast<std::size_t>(tree.parents()[i])];
      const BranchMesh result = mesh_branches(tree, radii, {.circle_resolution = w});
      EXPECT_EQ(result.duplicated_rings, duplicates);
      const auto corners = static_cast<std::size_t>(w);
      EXPECT_EQ(result.mesh.vertex_count(), (corners + 1) * (tree.node_count() + duplicates));
      EXPECT_EQ(result.mesh.triangle_count(), 2 * corners * tree.edge_count());
    }
}

TEST(MeshBranches, ATubeOfFourHexagonsHasThirtySixTriangles) {
  const Skeleton tube = chain(3);
  const BranchMesh result =
      mesh_branches(tube, branch_radii(tube, 0.1, 2.0), {.circle_resolution = 6});
  EXPECT_EQ(result.mesh.vertex_count(), 28u);
  EXPECT_EQ(result.mesh.triangle_count(), 36u);
  const SurfaceEdges edges(result.mesh);
  EXPECT_EQ(edges.places(), 24u);
  EXPECT_EQ(edges.euler_characteristic(), 0);  // a cylinder
  EXPECT_EQ(edges.boundary_edges(), 2u * 6u);  // open at both ends
}

TEST(MeshBranchesLaw, EveryTipAndTheRootStayOpen) {
  const Skeleton tree = grown_tree();
  const BranchMesh result = mesh_branches(tree, branch_radii(tree, 0.007, 1.9), {});
  const SurfaceEdges edges(result.mesh);
  // A ring of w corners that k branches leave: its w edges have k + 1 faces, or 1 at an end. A
  // duplicate is a ring of its own, which only its branch leaves.
  const std::size_t ends = tip_count(tree) + 1 + result.duplicated_rings;
  const ChildLists children(tree);
  std::size_t closed_by_duplicates = 0;  // rings that all branches above leave through duplicates
  const std::vector<double> radii = branch_radii(tree, 0.007, 1.9);
  for (std::size_t node = 1; node < tree.node_count(); ++node) {
    const auto above = children.of(static_cast<std::int32_t>(node));
    closed_by_duplicates +=
        !above.empty() && std::all_of(above.begin(), above.end(), [&](std::int32_t child) {
          return needs_own_ring(radii[static_cast<std::size_t>(child)], radii[node], 0.49);
        });
  }
  EXPECT_EQ(edges.boundary_edges(), 3 * (ends + closed_by_duplicates));
}

/// Euler's number: a tube adds w corners, 3 w edges (ring, side, diagonal) and 2 w faces, so
/// nothing; a ring alone has none either.
TEST(MeshBranchesLaw, EulerCharacteristicIsZero) {
  const Skeleton tree = grown_tree();
  for (const int w : {3, 5, 8}) {
    const BranchMesh result =
        mesh_branches(tree, branch_radii(tree, 0.007, 1.9), {.circle_resolution = w});
    EXPECT_EQ(SurfaceEdges(result.mesh).euler_characteristic(), 0);
  }
}

TEST(MeshBranchesLaw, NormalsAreUnitAndEqualAtTheSeam) {
  const Skeleton tree = grown_tree();
  const TriangleMesh mesh = mesh_branches(tree, branch_radii(tree, 0.007, 1.9), {}).mesh;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    EXPECT_NEAR(norm(mesh.normals[i]), 1.0, 1e-12);
    if (i % 4 != 0) continue;
    EXPECT_EQ(mesh.normals[i], mesh.normals[i + 3]);
    EXPECT_EQ(mesh.positions[i], mesh.positions[i + 3]);
    EXPECT_EQ(mesh.texture_points[i].u, 0.0);
    EXPECT_EQ(mesh.texture_points[i + 3].u, 1.0);
  }
}

TEST(MeshBranchesLaw, TrianglesFaceOutwards) {
  for (const Skeleton& tree : {chain(6), hanging_tree()}) {
    const std::vector<double> radii = branch_radii(tree, 0.05, 2.0);
    const TriangleMesh mesh = mesh_branches(tree, radii, {.circle_resolution = 8}).mesh;
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      const Vector3 normal = cross(b - a, c - a);
      EXPECT_GT(norm(normal), 0.0);
      const std::size_t node = i / 16 + 1;  // two triangles for each of eight corners
      const Vector3 middle = 0.5 * (tree.positions()[node] + tree.position(tree.parents()[node]));
      EXPECT_GT(dot(normal, (a + b + c) / 3.0 - middle), 0.0) << "triangle " << i;
    }
  }
}

/// Consecutive rings must not twist: corresponding corners stay on the same side.
TEST(MeshBranchesLaw, RingsTurnedFromTheParentDoNotTwist) {
  const Skeleton tree = hanging_tree();
  const std::vector<double> radii = branch_radii(tree, 0.05, 2.0);
  const auto worst_twist = [&](RingTurn turn) {
    const TriangleMesh mesh =
        mesh_branches(tree, radii, {.circle_resolution = 8, .ring_turn = turn}).mesh;
    double worst = 1.0;
    for (std::size_t node = 1; node < tree.node_count(); ++node) {
      const auto below = static_cast<std::size_t>(tree.parents()[node]);
      const Vector3 axis = tree.positions()[node] - tree.positions()[below];
      const auto across = [&](std::size_t ring) {
        Vector3 v = mesh.positions[9 * ring] - tree.positions()[ring];
        v = v - (dot(v, axis) / squared_norm(axis)) * axis;
        return v / norm(v);
      };
      worst = std::min(worst, dot(across(node), across(below)));
    }
    return worst;
  };
  EXPECT_GT(worst_twist(RingTurn::from_parent), 0.9);
  EXPECT_LT(worst_twist(RingTurn::from_vertical), 0.2) << "the tree does not show what it should";
}

TEST(RingNormals, LookAtThickerChildrenMore) {
  Skeleton fork({0, 0, 0});
  fork.append(0, {0, 1, 0});
  fork.append(1, {1, 2, 0});
  fork.append(1, {-1, 2, 0});
  const std::vector<double> radii{1, 1, 0.9, 0.1};
  const auto normals = ring_normals(fork, radii, SingleChildNormal::bisector);
  const Vector3 expected{0.8, 1.0, 0.0};
  EXPECT_LE(norm(normals[1] - expected / norm(expected)), 1e-15);
  EXPECT_EQ(normals[0], (Vector3{0, 1, 0}));
  EXPECT_LE(norm(normals[2] - Vector3{1, 1, 0} / std::sqrt(2.0)), 1e-15);
}

TEST(RingNormals, OfASingleChildBisectOrLookAtIt) {
  Skeleton bend({0, 0, 0});
  bend.append(0, {0, 1, 0});
  bend.append(1, {1, 1, 0});
  const std::vector<double> radii{1, 1, 1};
  EXPECT_LE(norm(ring_normals(bend, radii, SingleChildNormal::bisector)[1] -
                 Vector3{1, 1, 0} / std::sqrt(2.0)),
            1e-15);
  EXPECT_EQ(ring_normals(bend, radii, SingleChildNormal::child)[1], (Vector3{1, 0, 0}));
}

TEST(MeshBranches, ARootAloneIsOneRing) {
  const Skeleton root({0, 0, 0});
  const BranchMesh result = mesh_branches(root, std::vector<double>{0.1}, {});
  EXPECT_EQ(result.mesh.vertex_count(), 4u);
  EXPECT_EQ(result.mesh.triangle_count(), 0u);
}

TEST(MeshBranches, SurvivesEdgesThatTurnBackOrHaveNoLength) {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0, 1, 0});
  tree.append(1, {0, 0, 0});
  tree.append(2, {0, 0, 0});
  tree.append(1, {1, 1, 0});
  tree.append(1, {-1, 1, 0});
  const TriangleMesh mesh = mesh_branches(tree, branch_radii(tree, 0.1, 2.0), {}).mesh;
  for (const Vector3& p : mesh.positions) EXPECT_TRUE(is_finite(p));
  for (const Vector3& n : mesh.normals) EXPECT_NEAR(norm(n), 1.0, 1e-12);
}

}  // namespace
}  // namespace phytobench
