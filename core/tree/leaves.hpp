// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/rotation.hpp"
#include "core/tree/skeleton.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

enum class LeafShape {
  cross_foil,  ///< two squares at right angles, each two-sided: 16 vertices, 8 triangles
  square,      ///< one two-sided square: 8 vertices, 4 triangles
};

struct LeafOptions {
  double per_node = 0.7;        ///< whole part always, fraction as a probability; [0, 1000]
  double size = 0.7;            ///< mean edge of a square, length units, > 0
  double size_spread = 0.2;     ///< standard deviation over mean, [0, 1] ([Brzoska2019] sec. 5.1)
  double radius_limit = 0.009;  ///< only branches thinner than this carry leaves, > 0
  LeafShape shape = LeafShape::cross_foil;
  std::uint64_t seed = 0;
};

/// One leaf. Each is a pure function of (seed, node, number at the node): another count or size
/// neither moves nor turns those that are shown anyway.
struct Leaf {
  Vector3 position;  ///< its center
  Rotation turned;   ///< uniform over all rotations
  double size = 0.0;
};

/// The leaves of a plant: on every node but the root whose branch is thin enough, each somewhere
/// between the node and its parent, uniformly. Sizes are normally distributed; one that is not
/// positive is drawn again. Radii per node. With another `per_node` the smaller set is a part of
/// the larger.
std::vector<Leaf> make_leaves(const Skeleton& skeleton, std::span<const double> radii,
                              const LeafOptions& options);

/// Nodes that may carry leaves.
std::size_t leaf_bearing_nodes(const Skeleton& skeleton, std::span<const double> radii,
                               double radius_limit);

/// Every side of every square has its own four vertices; texture points span the whole texture.
TriangleMesh mesh_leaves(std::span<const Leaf> leaves, LeafShape shape);

}  // namespace phytobench
