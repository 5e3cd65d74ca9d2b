// SPDX-License-Identifier: MIT
// The thesis' voxel grid as the thesis measured it: nodes in a grid for the search, removal by
// comparing every live point with every new node.
#include "core/nearest_node/voxel_index.hpp"

namespace phytobench::engines {

extern const EngineDescriptor voxel_grid;
constinit const EngineDescriptor voxel_grid{
    .name = "voxel_grid",
    .summary =
        "Looks into the 27 grid cells around a point; cells are as wide as the influence distance.",
    .source = "[Brzoska2019] sec. 5.2.2, voxel grid (idea attributed to Schneider)",
    .create = make_point_driven_engine<VoxelIndex>,
};

}  // namespace phytobench::engines
