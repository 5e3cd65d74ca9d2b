// SPDX-License-Identifier: MIT
// The voxel grid as its author would have built it for large trees: a second grid for removal,
// without which the time at a million points is that of comparing all pairs.
#include "core/nearest_node/voxel_index.hpp"

namespace phytobench::engines {

extern const EngineDescriptor two_voxel_grids;
constinit const EngineDescriptor two_voxel_grids{
    .name = "two_voxel_grids",
    .summary = "voxel_grid with a second grid, of the new nodes, for the removal of points.",
    .source = "phytobench, after [Brzoska2019] sec. 5.2.2",
    .create = make_point_driven_engine<VoxelIndex, KillBy::grid>,
};

}  // namespace phytobench::engines
