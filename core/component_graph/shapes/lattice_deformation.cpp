// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/lattice_deformation.hpp"

#include <algorithm>
#include <utility>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_points = 10;
using Weights = std::array<double, most_points>;

/// Bernstein polynomials of degree n - 1 at a share [0, 1], and their slopes, by the recursion of
/// their definition.
struct Basis {
  Weights values{}, slopes{};
};

Basis basis_at(std::size_t n, double share) {
  Basis basis;
  Weights& b = basis.values;
  b[0] = 1.0;
  for (std::size_t degree = 1; degree < n; ++degree) {
    if (degree + 1 == n) {  // b still holds those of one degree less
      for (std::size_t i = 0; i <= degree; ++i)
        basis.slopes[i] =
            static_cast<double>(degree) * ((i > 0 ? b[i - 1] : 0.0) - (i < degree ? b[i] : 0.0));
    }
    for (std::size_t i = degree; i > 0; --i) b[i] = (1.0 - share) * b[i] + share * b[i - 1];
    b[0] *= 1.0 - share;
  }
  return basis;
}

Weights weights_at(std::size_t n, double share) {
  const double inside = std::clamp(share, 0.0, 1.0);
  Basis basis = basis_at(n, inside);
  if (share == inside) return basis.values;
  for (std::size_t i = 0; i < n; ++i) basis.values[i] += (share - inside) * basis.slopes[i];
  return basis.values;
}

}  // namespace

LatticeDeformation::LatticeDeformation(const Frame& frame, Lattice lattice, Bends bends)
    : frame_(frame), lattice_(std::move(lattice)), bends_(bends) {
  const auto& points = lattice_.points;
  for (const std::size_t n : points) PHYTOBENCH_EXPECT(n >= 2 && n <= most_points);
  PHYTOBENCH_EXPECT(lattice_.moves.empty() ||
                    lattice_.moves.size() == points[0] * points[1] * points[2]);
  const Vector3 extent = lattice_.high - lattice_.low;
  PHYTOBENCH_EXPECT(extent.x > 0.0 && extent.y > 0.0 && extent.z > 0.0);
}

Vector3 LatticeDeformation::move_at(const Vector3& local) const {
  const auto& [low, high, points, moves] = lattice_;
  const Weights along_x = weights_at(points[0], (local.x - low.x) / (high.x - low.x));
  const Weights along_y = weights_at(points[1], (local.y - low.y) / (high.y - low.y));
  const Weights along_z = weights_at(points[2], (local.z - low.z) / (high.z - low.z));
  Vector3 sum;
  std::size_t next = 0;
  for (std::size_t k = 0; k < points[2]; ++k)
    for (std::size_t j = 0; j < points[1]; ++j)
      for (std::size_t i = 0; i < points[0]; ++i)
        sum = sum + (along_x[i] * along_y[j] * along_z[k]) * moves[next++];
  return sum;
}

Vector3 LatticeDeformation::moved(const Vector3& place) const {
  if (lattice_.moves.empty()) return place;
  // Only the move goes through the frame: where it is zero the place keeps its bits.
  return place + frame_.scale * frame_.direction(move_at(frame_.local_place(place)));
}

bool LatticeDeformation::bends(Surface surface) const {
  const bool is_leaf = surface == Surface::leaf;
  return bends_ == Bends::all || (bends_ == Bends::leaves) == is_leaf;
}

}  // namespace phytobench
