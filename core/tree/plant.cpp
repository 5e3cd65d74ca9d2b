// SPDX-License-Identifier: MIT
#include "core/tree/plant.hpp"

#include "core/tree/branch_angle_reduction.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

Plant make_plant(const Skeleton& grown, const PlantParameters& parameters) {
  Plant plant;
  plant.skeleton = parameters.angle_reduction > 0.0
                       ? bend_branches(reduce_branch_angles(grown, parameters.angle_reduction),
                                       parameters.pendulous)
                       : bend_branches(grown, parameters.pendulous);
  if (parameters.curve_reduction.cosine_above < 1.0)
    plant.skeleton = reduce_curves(plant.skeleton, parameters.curve_reduction).skeleton;
  plant.radii = branch_radii(plant.skeleton, parameters.tip_radius, parameters.radius_exponent);
  plant.branches = mesh_branches(plant.skeleton, plant.radii, parameters.branches);
  plant.leaves = make_leaves(plant.skeleton, plant.radii, parameters.leaves);
  plant.leaf_mesh = mesh_leaves(plant.leaves, parameters.leaves.shape);
  return plant;
}

}  // namespace phytobench
