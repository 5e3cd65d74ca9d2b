// SPDX-License-Identifier: MIT
// What can be measured of the surface of a component.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/tree/triangle_mesh.hpp"

namespace phytobench::experiments::lintermann1997 {

/// Positive where the triangles of a closed surface look outwards.
inline double enclosed_volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6.0;
  return sum;
}

inline double surface_area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& corner = mesh.positions[t[0]];
    sum += 0.5 * norm(cross(mesh.positions[t[1]] - corner, mesh.positions[t[2]] - corner));
  }
  return sum;
}

struct SurfaceTopology {
  std::int64_t open_edges = 0;  ///< directed edges without a partner: 0 for a closed surface
  std::int64_t euler = 0;       ///< vertices - edges + faces: 2 for a ball
};

/// Vertices at one place count as one: seams of the texture are no edges of the surface.
inline SurfaceTopology topology_of(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> number;
  for (const Vector3& p : mesh.positions)
    number.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size()))
                         .first->second);
  std::set<std::pair<std::uint32_t, std::uint32_t>> directed, undirected;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = number[t[i]], b = number[t[(i + 1) % 3]];
      directed.insert({a, b});
      undirected.insert(std::minmax(a, b));
    }
  SurfaceTopology topology;
  for (const auto& [a, b] : directed) topology.open_edges += !directed.contains({b, a});
  topology.euler = static_cast<std::int64_t>(places.size()) -
                   static_cast<std::int64_t>(undirected.size()) +
                   static_cast<std::int64_t>(mesh.triangle_count());
  return topology;
}

}  // namespace phytobench::experiments::lintermann1997
