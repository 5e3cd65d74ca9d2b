// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/tree/branch_mesh.hpp"
#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench {

oracles::brzoska2019::Point point_of(const Vector3& v);

/// A ring of a branch mesh.
struct ExpectedRing {
  oracles::brzoska2019::Point center;
  double radius = 0.0;
  oracles::brzoska2019::Point looks;  ///< unit vector across it
  std::size_t turned_from = 0;        ///< ring that it is turned from; itself at the root
  double height = 0.0;                ///< of its center, along the branches from the root
};

/// Rings of a skeleton by [Brzoska2019] sec. 5.1, in the order that mesh_branches() documents, and
/// for every node the ring that its own is joined to (0 for the root, which is joined to none).
struct ExpectedRings {
  std::vector<ExpectedRing> rings;
  std::vector<std::size_t> below;
  std::size_t duplicated = 0;

  /// Sides of triangles that belong to one only, in multiples of the corners of a ring: the root if
  /// a single tube leaves it, every duplicate, and every other ring that no tube leaves.
  std::size_t open_rings() const;
};

/// Which vertex of a mesh is which corner of which ring. Mesh and rings must outlive it.
class MeshRings {
 public:
  MeshRings(const TriangleMesh& mesh, const ExpectedRings& expected, int corners)
      : mesh_(mesh), expected_(expected), vertices_(static_cast<std::size_t>(corners) + 1) {}

  std::size_t ring_of(std::size_t vertex) const { return vertex / vertices_; }
  std::size_t corner_of(std::size_t vertex) const { return vertex % vertices_; }
  std::size_t first_vertex(std::size_t ring) const { return ring * vertices_; }
  oracles::brzoska2019::Point place(std::size_t vertex) const;
  /// From the center of its ring, in radii.
  oracles::brzoska2019::Point outward(std::size_t vertex) const;

 private:
  const TriangleMesh& mesh_;
  const ExpectedRings& expected_;
  std::size_t vertices_;  ///< of a ring: its corners, and the first again
};

ExpectedRings expected_rings(const Skeleton& skeleton, std::span<const double> radii,
                             const BranchMeshOptions& options);

}  // namespace phytobench
