// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/regression/checks/expected_rings.hpp"

namespace phytobench {

/// What is wrong with the triangles and normals between rings of so many corners that are in their
/// places, in one line; empty if nothing: see branch_mesh_check.hpp, which calls it. Triangles may
/// stand in any order. Their vertices must be there.
std::string objection_to_tubes(const TriangleMesh& mesh, const ExpectedRings& expected,
                               int corners);

}  // namespace phytobench
