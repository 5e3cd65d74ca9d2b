// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "core/component_graph/frame.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// The blade of a leaf ([Lintermann1997] sec. 4 and 5.1): an outline, folded along its middle, bent
/// along its length and waved at its edge. It begins at the origin and grows along y; x is across,
/// its upper side looks to -z.
struct LeafBlade {
  double length = 1.0;  ///< along the middle, > 0
  double width = 0.5;   ///< > 0
  /// Half widths as shares of width / 2, see half_width_spline.hpp.
  std::span<const double> outline;
  double fold_rad = 0.0;     ///< angle by which each half is lifted to the upper side
  double bend_rad = 0.0;     ///< turn from base to tip along an arc, positive to the lower side
  double wave_height = 0.0;  ///< of the edge, as a share of the width at that place
  double waves = 0.0;        ///< along the edge; both edges are half a wave apart
  int pieces_along = 8;      ///< >= 1
  int pieces_per_half = 2;   ///< >= 1
};

/// Where the middle of the blade is at a share [0, 1] of its length, with y along it and -z to its
/// upper side. On an arc of exactly that length.
Frame blade_middle(const LeafBlade& blade, double share);

/// Both sides, each with vertices of its own: the upper side first, then the lower one. Triangles
/// without area at a tip or base of no width are left out.
TriangleMesh mesh_blade(const LeafBlade& blade);

}  // namespace phytobench
