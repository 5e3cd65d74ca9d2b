// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/leaf_blade.hpp"

#include <cmath>
#include <numbers>

#include "core/component_graph/shapes/half_width_spline.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// One side, as a grid of rows from base to tip, each from the -x edge to the +x edge.
class BladeMesher {
 public:
  explicit BladeMesher(const LeafBlade& blade)
      : blade_(blade), columns_(2 * static_cast<std::uint32_t>(blade.pieces_per_half) + 1) {}

  TriangleMesh run() {
    for (int row = 0; row <= blade_.pieces_along; ++row) put_row(row);
    for (int row = 0; row < blade_.pieces_along; ++row) join(static_cast<std::uint32_t>(row));
    set_vertex_normals(mesh_);
    return std::move(mesh_);
  }

 private:
  double share_of(int row) const {
    return static_cast<double>(row) / static_cast<double>(blade_.pieces_along);
  }

  double half_width(int row) const {
    return 0.5 * blade_.width * half_width_at(blade_.outline, share_of(row));
  }

  void put_row(int row) {
    const double share = share_of(row), half = half_width(row);
    const Frame middle = blade_middle(blade_, share);
    const Vector3 up = -1.0 * middle.z;
    const double phase = 2.0 * std::numbers::pi * blade_.waves * share;
    for (std::uint32_t column = 0; column < columns_; ++column) {
      // -1 at one edge, 0 in the middle, 1 at the other.
      const double place =
          static_cast<double>(column) / static_cast<double>(blade_.pieces_per_half) - 1.0;
      const double wave = std::sin(place < 0.0 ? phase + std::numbers::pi : phase);
      const double lift = std::abs(place) * half * std::sin(blade_.fold_rad) +
                          2.0 * half * blade_.wave_height * place * place * wave;
      mesh_.positions.push_back(middle.origin +
                                (place * half * std::cos(blade_.fold_rad)) * middle.x + lift * up);
      mesh_.normals.push_back(up);
      mesh_.texture_points.push_back({0.5 * (place + 1.0), share});
    }
  }

  /// Seen from the upper side (-z, with y up) x grows to the left.
  void join(std::uint32_t row) {
    const std::uint32_t low = row * columns_, high = low + columns_;
    const bool has_low = half_width(static_cast<int>(row)) > 0.0;
    const bool has_high = half_width(static_cast<int>(row) + 1) > 0.0;
    for (std::uint32_t i = 0; i + 1 < columns_; ++i) {
      if (has_low) mesh_.triangles.push_back({low + i, high + i, low + i + 1});
      if (has_high) mesh_.triangles.push_back({low + i + 1, high + i, high + i + 1});
    }
  }

  const LeafBlade& blade_;
  std::uint32_t columns_;
  TriangleMesh mesh_;
};

/// The same surface seen from behind.
TriangleMesh reversed(TriangleMesh mesh) {
  for (Vector3& normal : mesh.normals) normal = -1.0 * normal;
  for (Triangle& triangle : mesh.triangles) triangle = {triangle[0], triangle[2], triangle[1]};
  return mesh;
}

}  // namespace

Frame blade_middle(const LeafBlade& blade, double share) {
  const double turn = share * blade.bend_rad, way = share * blade.length;
  // Chord and sagitta of an arc: a chord of length way sinc(turn / 2) at half the angle.
  const double half = 0.5 * turn;
  const double chord = half == 0.0 ? way : way * std::sin(half) / half;
  Frame frame;
  frame.origin = {0.0, chord * std::cos(half), chord * std::sin(half)};
  frame.y = {0.0, std::cos(turn), std::sin(turn)};
  frame.z = {0.0, -std::sin(turn), std::cos(turn)};
  return frame;
}

TriangleMesh mesh_blade(const LeafBlade& blade) {
  PHYTOBENCH_EXPECT(blade.pieces_along >= 1 && blade.pieces_per_half >= 1);
  TriangleMesh mesh = BladeMesher(blade).run();
  append(mesh, reversed(mesh));
  return mesh;
}

}  // namespace phytobench
