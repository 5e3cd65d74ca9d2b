// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// A cloud of points as something that can be rendered and exported: one equilateral triangle about
/// each point ([Brzoska2019] sec. 5.4 draws its attraction points so), in the order of the points.
/// All stand upright and face +z. `size` is the length of their sides, > 0.
TriangleMesh mesh_points(std::span<const Vector3> points, double size);

}  // namespace phytobench
