// SPDX-License-Identifier: MIT
// Rays from a square of vertices, side by side in vectors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/terrain/shadow/ray_groups.hpp"
#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

inline constexpr int ray_tile_side = 4;

struct RayTile {
  const RayGroups* groups = nullptr;  ///< made for tiles of ray_tile_side
  const RayCrossing* crossings = nullptr;
  std::size_t end = 0;           ///< how many of them are on the map for all rays of the tile
  const double* from = nullptr;  ///< the first vertex
  std::ptrdiff_t columns = 0;    ///< of the field
  int column = 0;                ///< of the first vertex
  int row = 0;
};

/// One bit for each vertex, row by row, the lowest first.
struct RayTileEnd {
  std::uint32_t dark = 0;  ///< some crossing before the end blocks the ray
  std::uint32_t open = 0;  ///< what is beyond may still do so
};

RayTileEnd follow_rays(const RayTile& tile, ShadowWork& work);

}  // namespace phytobench
