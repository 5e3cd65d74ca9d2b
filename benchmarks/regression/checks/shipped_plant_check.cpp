// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/shipped_plant_check.hpp"

#include <cmath>

#include <fmt/format.h>

#include "reference/component_counts.hpp"

namespace phytobench {

namespace {

bool is_finite_place(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string objection_to_mesh(const TriangleMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  if (mesh.triangles.empty()) return "has no triangles";
  if (mesh.normals.size() != vertices || mesh.texture_points.size() != vertices)
    return "has vertices without normals or texture points";
  for (std::size_t i = 0; i < vertices; ++i) {
    if (!is_finite_place(mesh.positions[i])) return fmt::format("vertex {} is nowhere", i);
    if (!(std::abs(norm(mesh.normals[i]) - 1.0) <= 1e-12))
      return fmt::format("normal {} has not the length 1", i);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    for (const std::uint32_t corner : triangle)
      if (corner >= vertices) return fmt::format("triangle {} has a corner that is missing", t);
    const Vector3& a = mesh.positions[triangle[0]];
    const Vector3 out = cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a);
    const Vector3 normals =
        mesh.normals[triangle[0]] + mesh.normals[triangle[1]] + mesh.normals[triangle[2]];
    if (dot(out, normals) < 0.0) return fmt::format("triangle {} looks against its normals", t);
  }
  return "";
}

}  // namespace

std::string objection_to_shipped_plant(const ComponentGraph& graph, const BuiltPlant& plant) {
  if (plant.instances.size() != graph.prototypes.size()) return "nothing was built";
  std::string counts = count_disagreement(graph, plant.instances, predicted_counts(graph));
  if (!counts.empty()) return counts;
  std::uint64_t triangles = 0;
  for (std::size_t i = 0; i < plant.parts.size(); ++i) {
    triangles += plant.parts[i].mesh.triangles.size();
    const std::string wrong = objection_to_mesh(plant.parts[i].mesh);
    if (!wrong.empty()) return fmt::format("part {} {}", i, wrong);
  }
  if (triangles == 0 || triangles != plant.triangle_count)
    return fmt::format("{} triangles, but {} were counted", triangles, plant.triangle_count);
  return "";
}

}  // namespace phytobench
