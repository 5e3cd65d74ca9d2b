// SPDX-License-Identifier: MIT
// Closed bodies ([Lintermann1997] sec. 4, Simple). Triangles look outwards.
#pragma once

#include "core/geometry/vector3.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// With the half axes of `half` (> 0) about a center: rings of `corners` (>= 3) corners at
/// `corners` / 2 steps from pole to pole, at least 2. Texture u goes around y, v from pole to pole.
TriangleMesh ellipsoid(const Vector3& center, const Vector3& half, int corners);

/// About y, closed by discs: half.x and half.z are the radii, half.y half the height.
TriangleMesh cylinder(const Vector3& center, const Vector3& half, int corners);

/// 24 vertices and 12 triangles; every face shows the whole texture.
TriangleMesh box(const Vector3& center, const Vector3& half);

}  // namespace phytobench
