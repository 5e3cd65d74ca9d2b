// SPDX-License-Identifier: MIT
#include "core/tree/point_cloud_mesh.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

const std::vector<Vector3> points{{0, 0, 0}, {1, 2, 3}, {-4, 0.5, 2}};

TEST(PointCloudMeshLaw, EveryPointIsTheCenterOfItsTriangle) {
  const TriangleMesh mesh = mesh_points(points, 0.1);
  ASSERT_EQ(mesh.triangle_count(), points.size());
  ASSERT_EQ(mesh.vertex_count(), 3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vector3 sum;
    for (const std::uint32_t corner : mesh.triangles[i]) sum = sum + mesh.positions[corner];
    EXPECT_LE(norm(sum / 3.0 - points[i]), 1e-15);
  }
}

TEST(PointCloudMeshLaw, TrianglesAreEquilateralAndFaceTheirNormals) {
  const TriangleMesh mesh = mesh_points(points, 0.1);
  for (const Triangle& t : mesh.triangles) {
    const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    for (const double side : {norm(b - a), norm(c - b), norm(a - c)}) EXPECT_NEAR(side, 0.1, 1e-15);
    for (const std::uint32_t corner : t)
      EXPECT_NEAR(dot(cross(b - a, c - a), mesh.normals[corner]), norm(cross(b - a, c - a)), 1e-15);
  }
}

TEST(PointCloudMesh, OfNoPointsIsEmpty) {
  EXPECT_EQ(mesh_points({}, 0.1).vertex_count(), 0u);
}

TEST(PointCloudMesh, RefusesTrianglesWithoutSize) {
  EXPECT_THROW(mesh_points(points, 0.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
