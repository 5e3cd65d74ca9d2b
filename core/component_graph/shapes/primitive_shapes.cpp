// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/primitive_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/component_graph/shapes/tapered_tube.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

Vector3 normalised(const Vector3& v) {
  const double length = norm(v);
  return length > 0.0 ? v / length : v;
}

/// Stretches a mesh of the unit body; its normals stay at right angles to the surface.
void stretch(TriangleMesh& mesh, const Vector3& center, const Vector3& half) {
  const double most = std::max({half.x, half.y, half.z});
  const Vector3 shrink{most / half.x, most / half.y, most / half.z};
  for (Vector3& place : mesh.positions) place = center + hadamard_product(half, place);
  for (Vector3& normal : mesh.normals) normal = normalised(hadamard_product(shrink, normal));
}

bool is_positive(const Vector3& half) {
  return half.x > 0.0 && half.y > 0.0 && half.z > 0.0;
}

}  // namespace

TriangleMesh ellipsoid(const Vector3& center, const Vector3& half, int corners) {
  PHYTOBENCH_EXPECT(corners >= 3 && is_positive(half));
  const int steps = std::max(2, corners / 2);
  std::vector<Frame> rings(static_cast<std::size_t>(steps) + 1);
  std::vector<double> radii(rings.size(), 0.0);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const double polar = std::numbers::pi * static_cast<double>(i) / steps;
    rings[i].origin = {0.0, -std::cos(polar), 0.0};
    if (i > 0 && i + 1 < rings.size()) radii[i] = std::sin(polar);
  }
  TriangleMesh mesh = tapered_tube(rings, radii, {.corners = corners, .caps = TubeCaps::none});
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    mesh.normals[i] = normalised(mesh.positions[i]);
    mesh.texture_points[i].v = 0.5 * (1.0 + mesh.positions[i].y);
  }
  stretch(mesh, center, half);
  return mesh;
}

TriangleMesh cylinder(const Vector3& center, const Vector3& half, int corners) {
  PHYTOBENCH_EXPECT(corners >= 3 && is_positive(half));
  std::array<Frame, 2> rings;
  rings[0].origin = {0.0, -1.0, 0.0};
  rings[1].origin = {0.0, 1.0, 0.0};
  TriangleMesh mesh =
      tapered_tube(rings, std::array{1.0, 1.0}, {.corners = corners, .texture_scale = half.y});
  stretch(mesh, center, half);
  return mesh;
}

TriangleMesh box(const Vector3& center, const Vector3& half) {
  PHYTOBENCH_EXPECT(is_positive(half));
  constexpr std::array<Vector3, 3> axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  TriangleMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3 normal = side * axes[axis];
      const Vector3 across = axes[(axis + 1) % 3], along = cross(normal, across);
      const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
      for (const auto& [u, v] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        const Vector3 corner = normal + (2.0 * u - 1.0) * across + (2.0 * v - 1.0) * along;
        mesh.positions.push_back(center + hadamard_product(half, corner));
        mesh.normals.push_back(normal);
        mesh.texture_points.push_back({u, v});
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

}  // namespace phytobench
