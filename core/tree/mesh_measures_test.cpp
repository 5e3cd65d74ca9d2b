// SPDX-License-Identifier: MIT
#include "core/tree/mesh_measures.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// A corner cut off a cube, with triangles that look outwards.
TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// The same with vertices of their own for each triangle, as a texture needs them.
TriangleMesh with_seams(const TriangleMesh& mesh) {
  TriangleMesh apart;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    for (const std::uint32_t vertex : t) apart.positions.push_back(mesh.positions[vertex]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

TEST(MeshMeasures, AreThoseOfATetrahedron) {
  EXPECT_NEAR(enclosed_volume(tetrahedron()), 1.0, 1e-15);
  EXPECT_NEAR(enclosed_volume(inside_out(tetrahedron())), -1.0, 1e-15);
  EXPECT_NEAR(surface_area(tetrahedron()), 1.0 + 1.5 + 3.0 + 0.5 * std::sqrt(4.0 + 9.0 + 36.0),
              1e-14);
}

TEST(SurfaceEdgesLaw, SeamsAreNoEdges) {
  for (const TriangleMesh& mesh : {tetrahedron(), with_seams(tetrahedron())}) {
    const SurfaceEdges edges(mesh);
    EXPECT_EQ(edges.places(), 4u);
    EXPECT_EQ(edges.open_edges(), 0u);
    EXPECT_EQ(edges.boundary_edges(), 0u);
    EXPECT_TRUE(edges.is_closed());
    EXPECT_EQ(edges.euler_characteristic(), 2);
  }
}

TEST(SurfaceEdges, SeesAHole) {
  TriangleMesh hole = tetrahedron();
  hole.triangles.pop_back();
  const SurfaceEdges edges(hole);
  EXPECT_EQ(edges.open_edges(), 3u);
  EXPECT_EQ(edges.boundary_edges(), 3u);
  EXPECT_FALSE(edges.is_closed());
  EXPECT_EQ(edges.euler_characteristic(), 1) << "a disc";
}

/// Its three edges are those of two triangles each, but both go the same way.
TEST(SurfaceEdges, SeesATriangleThatLooksInwards) {
  TriangleMesh turned = tetrahedron();
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  const SurfaceEdges edges(turned);
  EXPECT_EQ(edges.open_edges(), 3u);
  EXPECT_EQ(edges.boundary_edges(), 0u);
  EXPECT_FALSE(edges.is_closed());
  EXPECT_EQ(edges.euler_characteristic(), 2);
}

TEST(SurfaceEdges, SeesAThirdTriangleAtAnEdge) {
  TriangleMesh fin = tetrahedron();
  fin.positions.push_back({-1, -1, -1});
  fin.triangles.push_back({0, 1, 4});
  const SurfaceEdges edges(fin);
  EXPECT_FALSE(edges.is_closed());
  EXPECT_EQ(edges.open_edges(), 2u);
  EXPECT_EQ(edges.boundary_edges(), 2u);
  EXPECT_EQ(edges.euler_characteristic(), 5 - 8 + 5);
}

}  // namespace
}  // namespace phytobench
