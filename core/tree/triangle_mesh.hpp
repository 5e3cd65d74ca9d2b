// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector3.hpp"
#include "core/memory/large_array.hpp"

namespace phytobench {

/// Place on a texture; (0, 0) is its lower left corner.
struct TexturePoint {
  double u = 0.0;
  double v = 0.0;

  friend bool operator==(const TexturePoint&, const TexturePoint&) = default;
};

/// Vertex numbers, counter-clockwise seen from outside (right-handed, y up).
using Triangle = std::array<std::uint32_t, 3>;

/// Triangles with a normal and a texture point per vertex. Vertices are not shared where normal or
/// texture point differ.
struct TriangleMesh {
  LargeVector<Vector3> positions;
  LargeVector<Vector3> normals;  ///< unit length
  LargeVector<TexturePoint> texture_points;
  LargeVector<Triangle> triangles;

  std::size_t vertex_count() const { return positions.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
};

/// Gives every vertex the normalised sum of the normals of its triangles, weighted by area, and the
/// pairs in `seams` (vertices at one place) their common sum. Where that is zero the normal stays
/// as it is.
void set_vertex_normals(TriangleMesh& mesh,
                        std::span<const std::array<std::uint32_t, 2>> seams = {});

/// Appends `other` with its vertices renumbered.
void append(TriangleMesh& mesh, const TriangleMesh& other);

/// Cuts a mesh into parts of at most `most_vertices` (>= 3) vertices each, in the order of its
/// triangles; a vertex that several parts use is in each. [Brzoska2019] sec. 5.5.1: 16-bit indices
/// reach 65,536 vertices. (Sec. 3.7 limits triangles too, which indices do not: erratum E10.)
std::vector<TriangleMesh> split(const TriangleMesh& mesh, std::size_t most_vertices = 65536);

}  // namespace phytobench
