// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/ray_tile.hpp"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/terrain/shadow/ray_tile.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, ray_tile_side>;
using Doubles = hn::Vec<Tag>;
constexpr std::size_t side = ray_tile_side;
constexpr std::size_t lanes = hn::MaxLanes(Tag());
constexpr double dark_ray = std::numeric_limits<double>::infinity();
// Above everything, but no infinity: for a vertex without data.
constexpr double lit_ray = std::numeric_limits<double>::max();

/// The heights that rays come from, infinite once they are blocked.
struct Rays {
  HWY_ALIGN double from[side * side];

  HWY_INLINE void load(const RayTile& tile) {
    const Tag d;
    for (std::size_t i = 0; i < side * side; i += lanes) {
      const double* vertex =
          tile.from + static_cast<std::ptrdiff_t>(i / side) * tile.columns + i % side;
      const auto height = hn::LoadU(d, vertex);
      hn::Store(hn::IfThenElse(hn::Eq(height, height), height, hn::Set(d, lit_ray)), d, from + i);
    }
  }
  HWY_INLINE double lowest() const {
    const Tag d;
    auto lowest = hn::Load(d, from);
    for (std::size_t i = lanes; i < side * side; i += lanes)
      lowest = hn::Min(lowest, hn::Load(d, from + i));
    return hn::GetLane(hn::MinOfLanes(d, lowest));
  }
  /// The bits of those that are so high.
  template <class Is>
  HWY_INLINE std::uint32_t where(const Is& is) const {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < side * side; ++i) bits |= std::uint32_t{is(from[i])} << i;
    return bits;
  }
};

/// height_at() of the crossing against all rays of the tile.
HWY_INLINE void compare(const RayTile& tile, const RayCrossing& crossing, Rays& rays) {
  const Tag d;
  const double* near = tile.from + crossing.near;
  const double* far = tile.from + crossing.far;
  const auto fraction = hn::Set(d, crossing.fraction), rise = hn::Set(d, crossing.rise);
  for (std::size_t i = 0; i < side * side; i += lanes) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i / side) * tile.columns +
                              static_cast<std::ptrdiff_t>(i % side);
    const auto a = hn::LoadU(d, near + at), b = hn::LoadU(d, far + at);
    const auto height = hn::Add(a, hn::Mul(fraction, hn::Sub(b, a)));
    const auto from = hn::Load(d, rays.from + i), ray = hn::Add(from, rise);
    // The lower one of the height and its bound is above the ray.
    const auto bound = hn::IfThenElse(hn::Lt(a, b), b, a);
    const auto is_blocked = hn::And(hn::Gt(height, ray), hn::Gt(bound, ray));
    hn::Store(hn::IfThenElse(is_blocked, hn::Set(d, dark_ray), from), d, rays.from + i);
  }
}

RayTileEnd follow(const RayTile& tile, ShadowWork& work) {
  Rays rays;
  rays.load(tile);
  double lowest = rays.lowest();
  std::size_t next = 0;
  while ((next = tile.groups->may_block(lowest, tile.column, tile.row, next, tile.end, work)) <
         tile.end) {
    const std::size_t beyond = std::min(next + RayGroups::smallest, tile.end);
    work.samples += (beyond - next) * side * side;
    for (std::size_t c = next; c < beyond; ++c) compare(tile, tile.crossings[c], rays);
    next += RayGroups::smallest;
    lowest = rays.lowest();
  }
  const std::uint32_t dark = rays.where([](double from) { return from == dark_ray; });
  if (next == RayGroups::none) return {dark, 0};
  return {dark, rays.where([](double from) { return from < lit_ray; })};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

HWY_EXPORT(follow);

RayTileEnd follow_rays(const RayTile& tile, ShadowWork& work) {
  return HWY_DYNAMIC_DISPATCH(follow)(tile, work);
}

}  // namespace phytobench
#endif
