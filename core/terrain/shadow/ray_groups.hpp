// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/terrain/shadow/height_pyramid.hpp"
#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

/// The crossings of a RayPattern in groups of 4, 8, 16, ..., each with the window of a pyramid that
/// holds all heights that rays from a square tile of vertices meet there: a group is passed over in
/// one step where they are higher, about O(log n) steps a ray. Nothing is lost, for a window's
/// greatest height bounds every height_at() in it.
class RayGroups {
 public:
  static constexpr std::size_t smallest = 4;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// The pyramid must outlive this. Tiles have `tile` vertices a side.
  RayGroups(const HeightPyramid& pyramid, const RayPattern& pattern, int tile);

  /// The first crossing from `next` on, a multiple of `smallest`, that may block a ray of the tile
  /// whose first vertex is (column, row); no vertex of the tile from which rays come is lower than
  /// `lowest`. `end` or more if there is none before it, `none` if there is none beyond either.
  std::size_t may_block(double lowest, int column, int row, std::size_t next, std::size_t end,
                        ShadowWork& work) const {
    std::size_t level = 0;
    while (next < end) {
      const Group& group = levels_[level][next >> (level + smallest_shift)];
      const double ray = lowest + group.rise;
      if (!(highest_ > ray)) return none;
      ++work.blocks;
      if (group.highest_from(column, row) > ray) {
        if (level == 0) return next;
        --level;
        continue;
      }
      next += smallest << level;
      if (level + 1 < levels_.size() && next % (smallest << (level + 1)) == 0) ++level;
    }
    return next;
  }

 private:
  static constexpr std::size_t smallest_shift = 2;
  static_assert(smallest == 1 << smallest_shift);

  struct Group {
    double rise;           ///< m that rays have gained at its first crossing
    int left, top;         ///< where the box of its crossings begins, relative to the tile
    const float* highest;  ///< of the windows that hold such boxes
    int windows;           ///< in a row
    int shift;             ///< of their level

    double highest_from(int column, int row) const {
      // What lies outside the map is in no window: the box begins at its border.
      const int i = std::max(column + left, 0) >> shift, j = std::max(row + top, 0) >> shift;
      return static_cast<double>(
          highest[static_cast<std::size_t>(j) * static_cast<std::size_t>(windows) +
                  static_cast<std::size_t>(i)]);
    }
  };

  static Group group_of(const RayPattern& pattern, const HeightPyramid& pyramid, std::size_t first,
                        std::size_t last, int tile);

  double highest_;
  std::vector<std::vector<Group>> levels_;
};

}  // namespace phytobench
