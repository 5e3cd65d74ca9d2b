// SPDX-License-Identifier: MIT
// What can be measured of a surface made of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// Positive where the triangles of a closed surface look outwards.
double enclosed_volume(const TriangleMesh& mesh);

double surface_area(const TriangleMesh& mesh);

/// Edges of a mesh. Vertices at one place count as one: seams of a texture are no edges of the
/// surface.
class SurfaceEdges {
 public:
  explicit SurfaceEdges(const TriangleMesh& mesh);

  /// Places of vertices.
  std::size_t places() const { return places_; }
  /// Directed edges without one that goes back: 0 for a closed surface.
  std::size_t open_edges() const;
  /// Edges of a single triangle. Where two triangles look to different sides there is none, but
  /// there is an open edge.
  std::size_t boundary_edges() const;
  /// Every edge lies between two triangles that look to the same side.
  bool is_closed() const;
  /// Euler's number, vertices - edges + faces: 2 for a ball, 0 for a tube.
  std::int64_t euler_characteristic() const;

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  struct Directed {
    Edge edge;
    std::size_t times = 0;  ///< how many triangles go along it
  };
  std::size_t times_back(const Directed& there) const;

  std::size_t places_ = 0, faces_ = 0;
  std::vector<Directed> directed_;  ///< sorted, each once
};

}  // namespace phytobench
