// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/component_graph/build_context.hpp"
#include "core/component_graph/frame.hpp"

namespace phytobench {

/// Which meshes a deformation bends ([Lintermann1997] sec. 4: branches, but not leaves).
enum class Bends { all, all_but_leaves, leaves };

/// A box of control points, nx x ny x nz of them at equal distances, each moved by some vector.
struct Lattice {
  Vector3 low, high;  ///< of the box, in the frame; high > low in each direction
  std::array<std::size_t, 3> points{2, 2, 2};  ///< 2 to 10 in each direction
  std::vector<Vector3> moves;                  ///< x fastest, then y, then z; empty: none moves
};

/// Free-form deformation (Sederberg and Parry 1986): a place moves by the sum of the moves of the
/// control points, weighted by Bernstein polynomials of its place in the box. Outside, where the
/// original leaves everything as it is and tears what crosses the box, each polynomial goes on
/// along its tangent: smooth (once differentiable) and finite everywhere, and an affine lattice is
/// that affine map everywhere.
class LatticeDeformation final : public Deformation {
 public:
  LatticeDeformation(const Frame& frame, Lattice lattice, Bends bends);

  Vector3 moved(const Vector3& place) const override;
  bool bends(Surface surface) const override;

 private:
  Vector3 move_at(const Vector3& local) const;

  Frame frame_;
  Lattice lattice_;
  Bends bends_;
};

}  // namespace phytobench
