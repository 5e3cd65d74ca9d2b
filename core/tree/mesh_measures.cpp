// SPDX-License-Identifier: MIT
#include "core/tree/mesh_measures.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace phytobench {

double enclosed_volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles)
    sum += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6.0;
  return sum;
}

double surface_area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& corner = mesh.positions[t[0]];
    sum += 0.5 * norm(cross(mesh.positions[t[1]] - corner, mesh.positions[t[2]] - corner));
  }
  return sum;
}

SurfaceEdges::SurfaceEdges(const TriangleMesh& mesh) : faces_(mesh.triangle_count()) {
  std::map<std::array<double, 3>, std::uint32_t> at;
  std::vector<std::uint32_t> number;
  for (const Vector3& p : mesh.positions)
    number.push_back(
        at.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(at.size())).first->second);
  places_ = at.size();
  std::vector<Edge> all;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) all.push_back({number[t[i]], number[t[(i + 1) % 3]]});
  std::sort(all.begin(), all.end());
  for (const Edge& edge : all) {
    if (directed_.empty() || directed_.back().edge != edge) directed_.push_back({edge, 0});
    ++directed_.back().times;
  }
}

std::size_t SurfaceEdges::times_back(const Directed& there) const {
  const Edge back{there.edge.second, there.edge.first};
  const auto found =
      std::lower_bound(directed_.begin(), directed_.end(), back,
                       [](const Directed& one, const Edge& edge) { return one.edge < edge; });
  return found == directed_.end() || found->edge != back ? 0 : found->times;
}

std::size_t SurfaceEdges::open_edges() const {
  return static_cast<std::size_t>(
      std::count_if(directed_.begin(), directed_.end(),
                    [&](const Directed& one) { return times_back(one) == 0; }));
}

std::size_t SurfaceEdges::boundary_edges() const {
  return static_cast<std::size_t>(
      std::count_if(directed_.begin(), directed_.end(),
                    [&](const Directed& one) { return one.times == 1 && times_back(one) == 0; }));
}

bool SurfaceEdges::is_closed() const {
  return std::all_of(directed_.begin(), directed_.end(),
                     [&](const Directed& one) { return one.times == 1 && times_back(one) == 1; });
}

std::int64_t SurfaceEdges::euler_characteristic() const {
  // Of two directions of an edge the one to the higher number is counted.
  const auto edges = std::count_if(directed_.begin(), directed_.end(), [&](const Directed& one) {
    return one.edge.first <= one.edge.second || times_back(one) == 0;
  });
  return static_cast<std::int64_t>(places_) - static_cast<std::int64_t>(edges) +
         static_cast<std::int64_t>(faces_);
}

}  // namespace phytobench
