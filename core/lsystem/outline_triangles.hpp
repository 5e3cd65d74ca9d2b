// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector3.hpp"

namespace phytobench {

/// A filled outline in space.
struct OutlineTriangles {
  std::vector<Vector3> corners;  ///< of the outline, without repeats and spikes
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen against `normal`
  Vector3 normal;                                       ///< unit length; 0 if there is no area
  Vector3 across;                                       ///< unit vector in the outline's plane
};

/// Corners of an outline at most: finding triangles takes their third power at worst.
inline constexpr std::size_t most_outline_corners = 2000;

/// Cuts ears off ([Lintermann1997] fills what { and } enclose): right for every outline in a plane
/// that does not cross itself, concave ones too; corners may lie a little outside the plane. One
/// that crosses itself is filled somehow. One without area, or with less than three corners, has no
/// triangles. Takes at most most_outline_corners.
OutlineTriangles outline_triangles(std::span<const Vector3> outline);

}  // namespace phytobench
