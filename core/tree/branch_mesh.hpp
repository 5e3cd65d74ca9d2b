// SPDX-License-Identifier: MIT
// Branches as generalised cylinders: rings across the branches, joined by triangles ([Brzoska2019]
// sec. 2.2 and 5.1).
#pragma once

#include <span>
#include <vector>

#include "core/geometry/rotation.hpp"
#include "core/tree/skeleton.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// How a ring is turned about its own normal.
enum class RingTurn {
  from_parent,    ///< carried over from the ring below by the smallest rotation: no twist anywhere
  from_vertical,  ///< from the vertical by the smallest rotation, [Brzoska2019] eq. 3 literally:
                  ///< rings of hanging branches may twist against each other
};

/// Where the ring of a node with one child looks. With several children it is always the sum of
/// the edges to them, weighted by their radii ([Brzoska2019] sec. 5.1).
enum class SingleChildNormal {
  bisector,  ///< halfway between the edges below and above (as the author's program has it)
  child,     ///< along the edge above (the rule for several children, applied to one)
};

struct BranchMeshOptions {
  int circle_resolution = 3;  ///< w, corners of a ring, >= 3
  /// A child no thicker than this share of its parent gets a ring of its own at the parent's place:
  /// same radius as the child, looking at it. [0, 1]; the published counts need 0.4889 ... 0.4908.
  double duplicate_ratio = 0.49;
  RingTurn ring_turn = RingTurn::from_parent;
  SingleChildNormal single_child_normal = SingleChildNormal::bisector;
  double texture_length = 1.0;  ///< length along a branch after which the bark texture repeats, > 0
};

/// A circle with w corners about the unit vector that is `turned` up: its points are center +
/// radius
/// * turned(cos(360 i / w), 0, sin(360 i / w)) for i = 0 ... w - 1 ([Brzoska2019] eq. 1 to 3).
std::vector<Vector3> ring(const Vector3& center, double radius, const Rotation& turned,
                          int circle_resolution);

/// Unit vector that each node's ring is perpendicular to.
std::vector<Vector3> ring_normals(const Skeleton& skeleton, std::span<const double> radii,
                                  SingleChildNormal single_child);

/// Whether a child gets a ring of its own at its parent's place ([Brzoska2019] fig. 31; the text's
/// "difference" is a ratio, ambiguity A5).
bool needs_own_ring(double child_radius, double parent_radius, double duplicate_ratio);

struct BranchMesh {
  TriangleMesh mesh;
  std::size_t duplicated_rings = 0;
};

/// One ring per node, one more per duplicate, each of w + 1 vertices (the first corner again for
/// the texture's seam): (w + 1) (edges + 1 + duplicates) vertices and 2 w edges triangles. Rings
/// are in node order, then the duplicates. Open at the root and at every tip. Radii per node, > 0.
BranchMesh mesh_branches(const Skeleton& skeleton, std::span<const double> radii,
                         const BranchMeshOptions& options);

}  // namespace phytobench
