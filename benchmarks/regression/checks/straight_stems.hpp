// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/regression/checks/umbrella_check.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// Straight stems one after the other in a mesh, each as rings of its corners with the first corner
/// once more. Looks at the mesh alone. The mesh must outlive it.
class StraightStems {
 public:
  using Stem = UmbrellaPlant::Stem;

  StraightStems(const TriangleMesh& mesh, const Stem& stem, std::size_t count);

  /// Empty if all are what umbrella_check.hpp says of stems; nothing else may be asked before.
  std::string objection() const;

  Vector3 base(std::size_t i) const { return center(i, 0); }
  Vector3 tip(std::size_t i) const { return center(i, segments_); }
  Vector3 direction(std::size_t i) const;  ///< of length 1

 private:
  Vector3 center(std::size_t i, std::size_t ring) const;
  std::size_t vertex(std::size_t i, std::size_t ring, std::size_t corner) const;
  double radius(std::size_t ring) const;
  std::string objection_to_rings(std::size_t i) const;
  std::string objection_to_triangles(std::size_t i) const;

  const TriangleMesh& mesh_;
  const Stem& stem_;
  std::size_t count_, segments_, corners_;
};

}  // namespace phytobench
