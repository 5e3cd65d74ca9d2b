// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/pyramid_rays.hpp"

#include <algorithm>
#include <bit>

namespace phytobench {

PyramidRays::PyramidRays(const HeightField& field, const HeightPyramid& pyramid,
                         const SunDirection& sun, int tile)
    : field_(field), pattern_(field, sun), groups_(pyramid, pattern_, tile) {}

bool PyramidRays::is_blocked_from(std::size_t next, int column, int row, ShadowWork& work) const {
  const double* from = field_.row(row) + column;
  const std::size_t end = pattern_.on_map(column, row);
  while ((next = groups_.may_block(*from, column, row, next, end, work)) < end) {
    const std::size_t beyond = std::min(next + RayGroups::smallest, end);
    for (std::size_t c = next; c < beyond; ++c) {
      const RayCrossing& crossing = pattern_.crossings()[c];
      ++work.samples;
      if (height_at(crossing, from) > *from + crossing.rise) return true;
    }
    next += RayGroups::smallest;
  }
  return false;
}

std::uint32_t PyramidRays::lit_in_tile(int column, int row, ShadowWork& work) const {
  constexpr int last = ray_tile_side - 1;
  const std::size_t end = pattern_.on_map(pattern_.goes_east() ? column + last : column,
                                          pattern_.goes_south() ? row + last : row);
  const RayTileEnd met = follow_rays({&groups_, pattern_.crossings().data(), end,
                                      field_.row(row) + column, field_.columns(), column, row},
                                     work);
  std::uint32_t dark = met.dark;
  // Rays from the side away from the border have some way to go.
  const std::size_t next = end / RayGroups::smallest * RayGroups::smallest;
  for (std::uint32_t open = met.open; open != 0; open &= open - 1) {
    const int vertex = std::countr_zero(open);
    if (is_blocked_from(next, column + vertex % ray_tile_side, row + vertex / ray_tile_side, work))
      dark |= std::uint32_t{1} << vertex;
  }
  return ~dark;
}

}  // namespace phytobench
