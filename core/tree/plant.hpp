// SPDX-License-Identifier: MIT
// From a skeleton to everything that can be seen of a plant.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/picture/image.hpp"
#include "core/tree/branch_mesh.hpp"
#include "core/tree/curve_reduction.hpp"
#include "core/tree/leaves.hpp"
#include "core/tree/pendulous_branches.hpp"

namespace phytobench {

/// The look of a plant: none of it needs the skeleton to be grown again ([Brzoska2019] sec. 5.5.2).
/// The defaults are the start settings of the 2019 program.
struct PlantParameters {
  double tip_radius = 0.007;     ///< length units, > 0
  double radius_exponent = 1.9;  ///< n of eq. 12, > 0; the thesis' thickness t is n = 3 - 2 t
  /// Nodes move by this share of the way to their parents, [0, 1) ([Liebemann2017] sec. 3.4).
  double angle_reduction = 0.0;
  PendulousBranches pendulous;
  CurveReduction curve_reduction;  ///< after bending, so that node depths mean what they say
  BranchMeshOptions branches;
  LeafOptions leaves;
  Colour bark_colour = parse_colour("#6b4a2b");
  Colour leaf_colour = parse_colour("#457d29");
  std::string bark_texture;  ///< PNG file; empty: made from the colour
  std::string leaf_texture;  ///< PNG file; empty: particles in the colour
};

/// A plant's shape. Vertices and triangles are counted over branches and leaves.
struct Plant {
  Skeleton skeleton{Vector3{}};  ///< bent, if its branches hang; nodes may be left out
  std::vector<double> radii;     ///< per node
  BranchMesh branches;
  std::vector<Leaf> leaves;
  TriangleMesh leaf_mesh;

  std::size_t vertex_count() const {
    return branches.mesh.vertex_count() + leaf_mesh.vertex_count();
  }
  std::size_t triangle_count() const {
    return branches.mesh.triangle_count() + leaf_mesh.triangle_count();
  }
};

/// Dresses a grown skeleton, which stays as it is.
Plant make_plant(const Skeleton& grown, const PlantParameters& parameters);

/// n of eq. 12 for the thesis' thickness slider, [0, 1] to [3, 1] (value published by its author).
inline double radius_exponent_of(double thickness) {
  return 3.0 - 2.0 * thickness;
}

}  // namespace phytobench
