// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/component_graph/frame.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// Which ends of a tube are closed by a disc. An end of radius 0 is a point and needs none.
enum class TubeCaps { none, end, both };
inline constexpr std::array<std::string_view, 3> tube_cap_words{"none", "end", "both"};

struct TubeOptions {
  int corners = 6;  ///< of a ring, >= 3
  TubeCaps caps = TubeCaps::both;
  double texture_scale = 1.0;  ///< texture v is the length along the tube times it
};

/// Rings about the y axes of frames, joined to a surface ([Lintermann1997] fig. 3b). Corner i of w
/// looks along cos(360 i / w) x + sin(360 i / w) z; w + 1 vertices per ring, the first once more
/// for the seam of the texture; corners at one place where the radius is 0. Triangles look
/// outwards; those without area at a point are left out. Radii per ring, >= 0. No triangles if all
/// of them are 0.
TriangleMesh tapered_tube(std::span<const Frame> rings, std::span<const double> radii,
                          const TubeOptions& options);

}  // namespace phytobench
