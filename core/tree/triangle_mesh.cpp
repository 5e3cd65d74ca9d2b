// SPDX-License-Identifier: MIT
#include "core/tree/triangle_mesh.hpp"

#include <algorithm>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::uint32_t not_in_part = std::numeric_limits<std::uint32_t>::max();

/// Collects one part of a mesh.
class PartBuilder {
 public:
  explicit PartBuilder(const TriangleMesh& mesh)
      : mesh_(mesh), number_(mesh.vertex_count(), not_in_part) {}

  std::size_t vertices_with(const Triangle& triangle) const {
    std::size_t count = part_.vertex_count();
    for (const std::uint32_t vertex : triangle) count += number_[vertex] == not_in_part;
    return count;
  }

  void add(const Triangle& triangle) {
    Triangle renumbered;
    for (std::size_t corner = 0; corner < 3; ++corner)
      renumbered[corner] = number_in_part(triangle[corner]);
    part_.triangles.push_back(renumbered);
  }

  TriangleMesh take() {
    for (const std::uint32_t vertex : used_) number_[vertex] = not_in_part;
    used_.clear();
    return std::exchange(part_, {});
  }

 private:
  std::uint32_t number_in_part(std::uint32_t vertex) {
    if (number_[vertex] != not_in_part) return number_[vertex];
    number_[vertex] = static_cast<std::uint32_t>(part_.vertex_count());
    used_.push_back(vertex);
    part_.positions.push_back(mesh_.positions[vertex]);
    part_.normals.push_back(mesh_.normals[vertex]);
    part_.texture_points.push_back(mesh_.texture_points[vertex]);
    return number_[vertex];
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> number_;  // per vertex of the mesh
  std::vector<std::uint32_t> used_;
  TriangleMesh part_;
};

}  // namespace

void set_vertex_normals(TriangleMesh& mesh, std::span<const std::array<std::uint32_t, 2>> seams) {
  LargeVector<Vector3> sums(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    const Vector3& a = mesh.positions[t[0]];
    const Vector3 twice_area = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (const std::uint32_t vertex : t) sums[vertex] = sums[vertex] + twice_area;
  }
  for (const auto& [a, b] : seams) sums[a] = sums[b] = sums[a] + sums[b];
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double length = norm(sums[i]);
    if (length > 0.0) mesh.normals[i] = sums[i] / length;
  }
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
  mesh.texture_points.insert(mesh.texture_points.end(), other.texture_points.begin(),
                             other.texture_points.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

std::vector<TriangleMesh> split(const TriangleMesh& mesh, std::size_t most_vertices) {
  PHYTOBENCH_EXPECT(most_vertices >= 3);
  if (mesh.triangles.empty()) return {};
  if (mesh.vertex_count() <= most_vertices) return {mesh};
  std::vector<TriangleMesh> parts;
  PartBuilder builder(mesh);
  for (const Triangle& triangle : mesh.triangles) {
    if (builder.vertices_with(triangle) > most_vertices) parts.push_back(builder.take());
    builder.add(triangle);
  }
  parts.push_back(builder.take());
  return parts;
}

}  // namespace phytobench
