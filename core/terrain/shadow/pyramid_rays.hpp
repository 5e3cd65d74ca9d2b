// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/terrain/shadow/height_pyramid.hpp"
#include "core/terrain/shadow/ray_groups.hpp"
#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/ray_tile.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

/// Rays of one direction that pass over lower terrain in large steps. The answers are those of
/// exact_traversal bit by bit.
class PyramidRays {
 public:
  /// Field and pyramid must outlive this. With tiles of `tile` vertices a side, 1 for single rays.
  PyramidRays(const HeightField& field, const HeightPyramid& pyramid, const SunDirection& sun,
              int tile);

  bool is_blocked(int column, int row, ShadowWork& work) const {
    return is_blocked_from(0, column, row, work);
  }
  /// Which vertices are lit in the tile of ray_tile_side that begins there, one bit each, row by
  /// row. The tile must lie in the field.
  std::uint32_t lit_in_tile(int column, int row, ShadowWork& work) const;

 private:
  bool is_blocked_from(std::size_t next, int column, int row, ShadowWork& work) const;

  const HeightField& field_;
  RayPattern pattern_;
  RayGroups groups_;
};

}  // namespace phytobench
