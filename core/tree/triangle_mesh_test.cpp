// SPDX-License-Identifier: MIT
#include "core/tree/triangle_mesh.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// A strip of squares in the plane z = 0, each of two triangles that share an edge.
TriangleMesh strip(std::uint32_t squares) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= squares; ++i)
    for (const double y : {0.0, 1.0}) {
      mesh.positions.push_back({static_cast<double>(i), y, 0.0});
      mesh.normals.push_back({0, 0, 1});
      mesh.texture_points.push_back({static_cast<double>(i), y});
    }
  for (std::uint32_t i = 0; i < squares; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    mesh.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  return mesh;
}

std::multiset<std::array<double, 6>> corners_of(const TriangleMesh& mesh) {
  std::multiset<std::array<double, 6>> all;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    all.insert({a.x, a.y, b.x, b.y, c.x, c.y});
  }
  return all;
}

TEST(SplitLaw, KeepsEveryTriangleInPartsThatAreSmallEnough) {
  const TriangleMesh mesh = strip(100);
  for (const std::size_t most : {3u, 4u, 7u, 50u, 202u, 1000u}) {
    std::multiset<std::array<double, 6>> together;
    std::size_t parts = 0;
    for (const TriangleMesh& part : split(mesh, most)) {
      EXPECT_LE(part.vertex_count(), most);
      EXPECT_EQ(part.normals.size(), part.vertex_count());
      EXPECT_EQ(part.texture_points.size(), part.vertex_count());
      together.merge(corners_of(part));
      ++parts;
    }
    EXPECT_EQ(together, corners_of(mesh)) << most;
    EXPECT_GE(parts * most, mesh.vertex_count());
  }
}

TEST(Split, LeavesWhatFitsInOnePart) {
  const TriangleMesh mesh = strip(10);
  const auto parts = split(mesh, 22);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].triangles, mesh.triangles);
  EXPECT_EQ(split(mesh, 21).size(), 2u);
  EXPECT_TRUE(split(TriangleMesh{}).empty());
}

TEST(Append, RenumbersVertices) {
  TriangleMesh mesh = strip(1);
  append(mesh, strip(2));
  EXPECT_EQ(mesh.vertex_count(), 10u);
  EXPECT_EQ(mesh.triangles.back(), (Triangle{7, 8, 9}));
}

TEST(VertexNormals, WeighTrianglesByArea) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  mesh.normals.resize(4);
  mesh.texture_points.resize(4);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};  // area 2 along z, area 1 along x
  set_vertex_normals(mesh);
  EXPECT_LE(norm(mesh.normals[0] - Vector3{1, 0, 2} / std::sqrt(5.0)), 1e-15);
  EXPECT_EQ(mesh.normals[1], (Vector3{0, 0, 1}));
  EXPECT_EQ(mesh.normals[3], (Vector3{1, 0, 0}));
}

TEST(VertexNormals, AreCommonAtASeamAndKeptWhereNothingDefinesThem) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  mesh.normals.assign(7, {0, 1, 0});
  mesh.texture_points.resize(7);
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  set_vertex_normals(mesh, std::vector<std::array<std::uint32_t, 2>>{{0, 3}});
  EXPECT_EQ(mesh.normals[0], mesh.normals[3]);
  EXPECT_LE(norm(mesh.normals[0] - Vector3{1, 0, 1} / std::sqrt(2.0)), 1e-15);
  EXPECT_EQ(mesh.normals[6], (Vector3{0, 1, 0}));
}

}  // namespace
}  // namespace phytobench
