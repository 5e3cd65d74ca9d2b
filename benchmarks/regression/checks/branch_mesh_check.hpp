// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "core/tree/branch_mesh.hpp"

namespace phytobench {

/// What is wrong with the mesh of a skeleton's branches, in one line; empty if nothing. It is held
/// against [Brzoska2019] sec. 2.2 and 5.1 through equations that share no code with core/: counts;
/// every corner in its place on its ring, so at the ring's radius from the center, in the plane
/// that looks along the branches, and turned as the options say; every triangle of every tube there
/// once and outward; sides open at the root, the tips and duplicated rings alone; vertex normals
/// and texture points. Lengths to 1e-9 of a radius, for trees thousands of radii high.
///
/// Where branches turn back within 3 degrees the smallest rotation is not well defined: there only
/// a ring's plane and radius are looked at. Edges must have a length, radii too.
std::string objection_to_branch_mesh(const BranchMesh& branches, const Skeleton& skeleton,
                                     std::span<const double> radii,
                                     const BranchMeshOptions& options);

}  // namespace phytobench
