// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/tapered_tube.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

class TubeMesher {
 public:
  TubeMesher(std::span<const Frame> rings, std::span<const double> radii,
             const TubeOptions& options)
      : rings_(rings),
        radii_(radii),
        options_(options),
        corners_(static_cast<std::uint32_t>(options.corners)) {}

  TriangleMesh run() {
    double length = 0.0;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (i > 0) length += norm(rings_[i].origin - rings_[i - 1].origin);
      put_ring(i, options_.texture_scale * length);
      if (i > 0) join(i);
    }
    set_normals();
    if (options_.caps == TubeCaps::both) put_cap(0);
    if (options_.caps != TubeCaps::none) put_cap(rings_.size() - 1);
    return std::move(mesh_);
  }

 private:
  void put_ring(std::size_t i, double v) {
    const Frame& ring = rings_[i];
    for (std::uint32_t corner = 0; corner <= corners_; ++corner) {
      const double share = static_cast<double>(corner) / corners_;
      // The last is the first once more, to the bit.
      const double angle = corner == corners_ ? 0.0 : 2.0 * std::numbers::pi * share;
      const Vector3 out = std::cos(angle) * ring.x + std::sin(angle) * ring.z;
      mesh_.positions.push_back(ring.origin + radii_[i] * out);
      mesh_.normals.push_back(out);
      mesh_.texture_points.push_back({share, v});
    }
  }

  void join(std::size_t above) {
    const auto high = static_cast<std::uint32_t>(above) * (corners_ + 1);
    const std::uint32_t low = high - (corners_ + 1);
    for (std::uint32_t i = 0; i < corners_; ++i) {
      if (radii_[above - 1] > 0.0) mesh_.triangles.push_back({low + i, high + i, low + i + 1});
      if (radii_[above] > 0.0) mesh_.triangles.push_back({low + i + 1, high + i, high + i + 1});
    }
  }

  void set_normals() {
    std::vector<std::array<std::uint32_t, 2>> seams;
    for (std::uint32_t ring = 0; ring < rings_.size(); ++ring)
      seams.push_back({ring * (corners_ + 1), ring * (corners_ + 1) + corners_});
    set_vertex_normals(mesh_, seams);
  }

  /// A disc of its own vertices, so that the edge is sharp.
  void put_cap(std::size_t ring) {
    if (!(radii_[ring] > 0.0)) return;
    const bool is_end = ring != 0;
    const auto from = ring * (corners_ + 1);
    const auto first = static_cast<std::uint32_t>(mesh_.vertex_count());
    for (std::size_t i = from; i < from + corners_; ++i) {
      const Vector3 place = mesh_.positions[i];
      const TexturePoint texture = mesh_.texture_points[i];
      mesh_.positions.push_back(place);
      mesh_.normals.push_back(is_end ? rings_[ring].y : -1.0 * rings_[ring].y);
      mesh_.texture_points.push_back(texture);
    }
    for (std::uint32_t i = 1; i + 1 < corners_; ++i)
      mesh_.triangles.push_back(is_end ? Triangle{first, first + i + 1, first + i}
                                       : Triangle{first, first + i, first + i + 1});
  }

  std::span<const Frame> rings_;
  std::span<const double> radii_;
  const TubeOptions& options_;
  std::uint32_t corners_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh tapered_tube(std::span<const Frame> rings, std::span<const double> radii,
                          const TubeOptions& options) {
  PHYTOBENCH_EXPECT(options.corners >= 3);
  PHYTOBENCH_EXPECT(rings.size() >= 2 && rings.size() == radii.size());
  if (std::all_of(radii.begin(), radii.end(), [](double radius) { return radius == 0.0; }))
    return {};
  return TubeMesher(rings, radii, options).run();
}

}  // namespace phytobench
