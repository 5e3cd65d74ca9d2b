// SPDX-License-Identifier: MIT
#include "core/lsystem/block_writer.hpp"

#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lsystem/block_writer.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A segment in one vector, or in two on older processors.
using Ends = hn::CappedTag<double, 4>;
constexpr std::size_t numbers_of_a_segment = 4;

/// Only Mul and Add: MulAdd would round differently from target to target.
template <bool past_cache>
void move_planar(const double* from, std::size_t segments, PlaneDirection heading, double x,
                 double y, double* out) {
  const Ends d;
  const std::size_t lanes = hn::Lanes(d);
  // Processors before AVX: with two lanes the vector form gave other numbers, so plain arithmetic.
  if (lanes < numbers_of_a_segment) {
    for (std::size_t i = 0; i < segments * numbers_of_a_segment; i += 2) {
      const double a = from[i], b = from[i + 1];
      out[i] = (a * heading.x + b * -heading.y) + x;
      out[i + 1] = (b * heading.x + a * heading.y) + y;
    }
    return;
  }
  const auto cosine = hn::Set(d, heading.x);
  const auto sine = hn::OddEven(hn::Set(d, heading.y), hn::Set(d, -heading.y));
  const auto move = hn::OddEven(hn::Set(d, y), hn::Set(d, x));
  for (std::size_t i = 0; i < segments * numbers_of_a_segment; i += lanes) {
    const auto v = hn::LoadU(d, from + i);
    const auto turned = hn::Add(hn::Mul(v, cosine), hn::Mul(hn::Reverse2(d, v), sine));
    const auto moved = hn::Add(turned, move);
    if constexpr (past_cache)
      hn::Stream(moved, d, out + i);
    else
      hn::StoreU(moved, d, out + i);
  }
}

void move_planar_cached(const double* from, std::size_t segments, PlaneDirection heading, double x,
                        double y, double* out) {
  move_planar<false>(from, segments, heading, x, y, out);
}

void move_planar_past_cache(const double* from, std::size_t segments, PlaneDirection heading,
                            double x, double y, double* out) {
  move_planar<true>(from, segments, heading, x, y, out);
}

/// Returns how many points it wrote; the others do not fill a vector.
std::size_t move_spatial(const double* from, std::size_t points, const TurtleFrame& frame,
                         const Vector3& position, double* out) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  // Two lanes gain nothing here: the caller's loop does it.
  if (lanes < 4) return 0;
  const auto [h, l, u] = frame;
  const auto moved = [&](auto a, auto b, auto c, double hi, double li, double ui, double at) {
    const auto in_plane = hn::Add(hn::Mul(a, hn::Set(d, hi)), hn::Mul(b, hn::Set(d, li)));
    return hn::Add(hn::Add(in_plane, hn::Mul(c, hn::Set(d, ui))), hn::Set(d, at));
  };
  std::size_t i = 0;
  for (; i + lanes <= points; i += lanes) {
    const auto a = hn::LoadU(d, from + i);
    const auto b = hn::LoadU(d, from + points + i);
    const auto c = hn::LoadU(d, from + 2 * points + i);
    hn::StoreInterleaved3(moved(a, b, c, h.x, l.x, u.x, position.x),
                          moved(a, b, c, h.y, l.y, u.y, position.y),
                          moved(a, b, c, h.z, l.z, u.z, position.z), d, out + 3 * i);
  }
  return i;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

namespace {

HWY_EXPORT(move_planar_cached);
HWY_EXPORT(move_planar_past_cache);
HWY_EXPORT(move_spatial);

static_assert(sizeof(PlanarSegment) == 4 * sizeof(double));
static_assert(sizeof(SpatialSegment) == 6 * sizeof(double));

}  // namespace

void move_block(std::span<const PlanarSegment> drawing, PlaneDirection heading, double x, double y,
                PlanarSegment* out, Stores stores) {
  const double* const from = &drawing.data()->from_x;
  constexpr std::uintptr_t vector_bytes = 32;
  if (stores == Stores::past_cache && reinterpret_cast<std::uintptr_t>(out) % vector_bytes == 0)
    HWY_DYNAMIC_DISPATCH(move_planar_past_cache)
  (from, drawing.size(), heading, x, y, &out->from_x);
  else HWY_DYNAMIC_DISPATCH(move_planar_cached)(from, drawing.size(), heading, x, y, &out->from_x);
}

void move_block(const double* drawing, std::size_t count, const TurtleFrame& frame,
                const Vector3& position, SpatialSegment* out) {
  const std::size_t points = 2 * count;
  double* const to = &out->from.x;
  std::size_t i = HWY_DYNAMIC_DISPATCH(move_spatial)(drawing, points, frame, position, to);
  for (; i < points; ++i) {
    const double a = drawing[i], b = drawing[points + i], c = drawing[2 * points + i];
    const Vector3 moved = ((a * frame.heading + b * frame.left) + c * frame.up) + position;
    to[3 * i] = moved.x;
    to[3 * i + 1] = moved.y;
    to[3 * i + 2] = moved.z;
  }
}

void finish_stores() {
  hwy::FlushStream();
}

}  // namespace phytobench
#endif
