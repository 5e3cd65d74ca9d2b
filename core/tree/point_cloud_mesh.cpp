// SPDX-License-Identifier: MIT
#include "core/tree/point_cloud_mesh.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

TriangleMesh mesh_points(std::span<const Vector3> points, double size) {
  PHYTOBENCH_EXPECT(size > 0.0 && std::isfinite(size));
  const double inner = size / (2.0 * std::sqrt(3.0));  // radius of the circle inside
  const Vector3 corners[3] = {
      {-0.5 * size, -inner, 0.0}, {0.5 * size, -inner, 0.0}, {0.0, 2.0 * inner, 0.0}};
  constexpr TexturePoint texture_corners[3] = {{0.0, 0.0}, {1.0, 0.0}, {0.5, 1.0}};
  TriangleMesh mesh;
  mesh.positions.reserve(3 * points.size());
  mesh.normals.reserve(3 * points.size());
  mesh.texture_points.reserve(3 * points.size());
  mesh.triangles.reserve(points.size());
  for (const Vector3& point : points) {
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.positions.push_back(point + corners[i]);
      mesh.normals.push_back({0.0, 0.0, 1.0});
      mesh.texture_points.push_back(texture_corners[i]);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace phytobench
