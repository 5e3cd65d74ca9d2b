// SPDX-License-Identifier: MIT
#include "core/tree/plant.hpp"

#include "core/tree/branches.hpp"

namespace phytobench {

Plant make_plant(const Skeleton& grown, const PlantParameters& parameters) {
  Plant plant;
  plant.skeleton = bend_branches(grown, parameters.pendulous);
  plant.radii = branch_radii(plant.skeleton, parameters.tip_radius, parameters.radius_exponent);
  plant.branches = mesh_branches(plant.skeleton, plant.radii, parameters.branches);
  plant.leaves = make_leaves(plant.skeleton, plant.radii, parameters.leaves);
  plant.leaf_mesh = mesh_leaves(plant.leaves, parameters.leaves.shape);
  return plant;
}

}  // namespace phytobench
