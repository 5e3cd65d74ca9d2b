// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "core/tree/leaves.hpp"

namespace phytobench {

/// What is wrong with the leaves of a skeleton, in one line; empty if nothing. Each must lie on the
/// edge below a node thin enough to carry it, in the order of nodes, as many at each as the options
/// allow; their number, mean size and mean place on the edge must be likely (within five standard
/// deviations).
std::string objection_to_leaves(std::span<const Leaf> leaves, const Skeleton& skeleton,
                                std::span<const double> radii, const LeafOptions& options);

/// The same for their mesh: squares of each leaf's size around its place, turned as the leaf is,
/// the second at right angles to the first; both sides of each with four vertices of their own, two
/// triangles that face as the normals do, and the whole texture. Lengths to 1e-9 of a leaf.
std::string objection_to_leaf_mesh(const TriangleMesh& mesh, std::span<const Leaf> leaves,
                                   LeafShape shape);

}  // namespace phytobench
