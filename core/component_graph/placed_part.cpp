// SPDX-License-Identifier: MIT
#include "core/component_graph/placed_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Derivatives of a deformation along x, y and z.
using Columns = std::array<Vector3, 3>;

Columns derivatives(const Deformation& deformation, const Vector3& place) {
  const double largest = std::max({1.0, std::abs(place.x), std::abs(place.y), std::abs(place.z)});
  const double step = 1e-6 * largest;  // rounding and curvature cost about equally much
  const std::array<Vector3, 3> axes{Vector3{step, 0.0, 0.0}, Vector3{0.0, step, 0.0},
                                    Vector3{0.0, 0.0, step}};
  Columns columns;
  for (std::size_t i = 0; i < 3; ++i)
    columns[i] =
        (deformation.moved(place + axes[i]) - deformation.moved(place - axes[i])) / (2.0 * step);
  return columns;
}

Vector3 mapped(const Columns& columns, const Vector3& v) {
  return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
}

/// Normals go with the cofactors, so that they stay at right angles to the surface.
Vector3 mapped_normal(const Columns& c, const Vector3& normal) {
  const Vector3 across = mapped({cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])}, normal);
  const double length = norm(across);
  return length > 0.0 && std::isfinite(length) ? across / length : normal;
}

void bend(TriangleMesh& mesh, const Deformation& deformation) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Vector3 place = mesh.positions[i];
    mesh.positions[i] = deformation.moved(place);
    mesh.normals[i] = mapped_normal(derivatives(deformation, place), mesh.normals[i]);
  }
}

void carry(TriangleMesh& mesh, const Frame& from, const Frame& to) {
  for (Vector3& place : mesh.positions) place = to.place(from.local_place(place));
  for (Vector3& normal : mesh.normals) normal = to.direction(from.local_direction(normal));
}

void expect_whole(const TriangleMesh& mesh) {
  PHYTOBENCH_EXPECT(mesh.normals.size() == mesh.vertex_count());
  PHYTOBENCH_EXPECT(mesh.texture_points.size() == mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) PHYTOBENCH_EXPECT(vertex < mesh.vertex_count());
}

}  // namespace

bool is_within_reach(const Vector3& place) {
  return std::abs(place.x) <= largest_coordinate && std::abs(place.y) <= largest_coordinate &&
         std::abs(place.z) <= largest_coordinate;
}

Frame deformed(const Frame& frame, const Deformation& deformation) {
  const Columns columns = derivatives(deformation, frame.origin);
  Frame moved = frame;
  moved.origin = deformation.moved(frame.origin);
  const Vector3 y = mapped(columns, frame.y), x = mapped(columns, frame.x);
  constexpr double flat = 1e-9;
  const double y_length = norm(y);
  if (!(y_length > flat) || !(norm(cross(x, y)) > flat * y_length)) return moved;
  moved.x = x;
  moved.y = y;
  return orthonormal(moved);
}

bool place_part(MeshPart& part, const Frame& frame,
                std::span<const std::shared_ptr<const Deformation>> deformations) {
  expect_whole(part.mesh);
  carry(part.mesh, Frame{}, frame);
  Frame carried = frame;
  for (auto next = deformations.rbegin(); next != deformations.rend(); ++next) {
    const Frame moved = deformed(carried, **next);
    (*next)->bends(part.material.surface) ? bend(part.mesh, **next)
                                          : carry(part.mesh, carried, moved);
    carried = moved;
  }
  return std::all_of(part.mesh.positions.begin(), part.mesh.positions.end(),
                     [](const Vector3& place) { return is_within_reach(place); });
}

}  // namespace phytobench
