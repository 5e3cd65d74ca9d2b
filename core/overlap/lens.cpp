// SPDX-License-Identifier: MIT
// A chord cuts a segment off each disc. With phi its opening angle there, the segment of the unit
// disc is (phi - sin phi) / 2, and z = sin^2(phi / 4) follows from the sides of the triangle of
// both centers and a corner of the lens as a product of differences over a product (Heron): nothing
// cancels that is not exact, and no arc function is asked for what it cannot tell. (phi - sin phi)
// / z^(3/2) hardly varies for z <= 1/2, so a polynomial gives it to the last bits; beyond, the rest
// of the disc is such a segment.
#include "core/overlap/lens.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "core/contract/check.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/overlap/lens.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#ifndef PHYTOBENCH_LENS_COEFFICIENTS
#define PHYTOBENCH_LENS_COEFFICIENTS
namespace phytobench {

/// (phi - sin phi) / z^(3/2) by powers of 4 z - 1 for z in [0, 1/2]: interpolated at the Chebyshev
/// nodes with 60 digits; relative error of the polynomial 7e-17.
inline constexpr double segment_coefficients[] = {
    9.826957588870055,       -0.8840299227540568,     -0.04966313493666974,
    -0.006209705817510793,   -0.0010328346945210612,  -0.0002003407879064406,
    -4.283115930725359e-05,  -9.795289795027282e-06,  -2.353870994170595e-06,
    -5.874423648670886e-07,  -1.51099245821081e-07,   -4.0011116145388815e-08,
    -1.0764600875065263e-08, -2.7445212606665977e-09, -7.59300477811925e-10,
    -3.276953174778744e-10,  -9.37156526571395e-11};
inline constexpr int segment_degree = static_cast<int>(std::size(segment_coefficients)) - 1;
static_assert(segment_degree % 2 == 0);  // even and odd powers are summed apart: half the waiting

}  // namespace phytobench
#endif

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using Doubles = hn::Vec<Tag>;

/// phi - sin phi. Only Mul and Add: MulAdd would round differently from target to target.
HWY_INLINE Doubles segment(Doubles z) {
  const Tag d;
  const auto x = hn::Sub(hn::Mul(hn::Set(d, 4.0), z), hn::Set(d, 1.0));
  const auto square = hn::Mul(x, x);
  auto even = hn::Set(d, segment_coefficients[segment_degree]);
  auto odd = hn::Set(d, segment_coefficients[segment_degree - 1]);
  for (int k = segment_degree - 2; k > 0; k -= 2) {
    even = hn::Add(hn::Mul(even, square), hn::Set(d, segment_coefficients[k]));
    odd = hn::Add(hn::Mul(odd, square), hn::Set(d, segment_coefficients[k - 1]));
  }
  even = hn::Add(hn::Mul(even, square), hn::Set(d, segment_coefficients[0]));
  return hn::Mul(hn::Mul(z, hn::Sqrt(z)), hn::Add(even, hn::Mul(odd, x)));
}

/// Step by step as lens_area().
HWY_INLINE Doubles lens(Doubles r, Doubles s, Doubles distance) {
  const Tag d;
  const auto zero = hn::Zero(d), half = hn::Set(d, 0.5), two = hn::Set(d, 2.0),
             four = hn::Set(d, 4.0);
  const auto swap = hn::Lt(s, r);
  const auto small = hn::IfThenElse(swap, s, r);
  const auto large = hn::IfThenElse(swap, r, s);
  const auto beyond = hn::Sub(distance, large);
  const auto overlap = hn::Sub(small, beyond);
  const auto small_beyond =
      hn::IfThenElse(hn::Ge(hn::Mul(two, distance), large), hn::Add(small, beyond),
                     hn::Sub(distance, hn::Sub(large, small)));
  const auto large_beyond =
      hn::IfThenElse(hn::Le(large, hn::Mul(two, small)), hn::Add(hn::Sub(large, small), distance),
                     hn::Add(large, hn::Sub(distance, small)));
  const auto around = hn::Add(hn::Add(small, large), distance);
  const auto scale =
      hn::Div(hn::Set(d, 1.0), hn::Mul(hn::Mul(hn::Mul(four, small), large), distance));
  const auto small_scale = hn::Mul(small, scale), large_scale = hn::Mul(large, scale);
  const auto z_small = hn::Mul(hn::Mul(large_beyond, overlap), large_scale);
  const auto z_rest = hn::Mul(hn::Mul(around, small_beyond), large_scale);
  const auto z_large = hn::Mul(hn::Mul(small_beyond, overlap), small_scale);
  const auto beyond_half = hn::Gt(z_small, half);
  const auto part = segment(hn::IfThenElse(beyond_half, z_rest, z_small));
  const auto of_small =
      hn::IfThenElse(beyond_half, hn::Sub(hn::Set(d, 2.0 * std::numbers::pi), part), part);
  const auto area = hn::Mul(half, hn::Add(hn::Mul(hn::Mul(small, small), of_small),
                                          hn::Mul(hn::Mul(large, large), segment(z_large))));
  const auto disc = hn::Mul(hn::Mul(hn::Set(d, std::numbers::pi), small), small);
  const auto inside = hn::Le(small_beyond, zero);
  const auto apart = hn::Le(overlap, zero);
  return hn::IfThenElse(apart, zero, hn::IfThenElse(inside, disc, area));
}

void lenses(const double* r, const double* s, const double* distance, double* area,
            std::size_t count) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    hn::StoreU(lens(hn::LoadU(d, r + i), hn::LoadU(d, s + i), hn::LoadU(d, distance + i)), d,
               area + i);
  for (; i < count; ++i) area[i] = lens_area(r[i], s[i], distance[i]);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

namespace {

HWY_EXPORT(lenses);

double segment(double z) {
  const double x = 4.0 * z - 1.0;
  const double square = x * x;
  double even = segment_coefficients[segment_degree];
  double odd = segment_coefficients[segment_degree - 1];
  for (int k = segment_degree - 2; k > 0; k -= 2) {
    even = even * square + segment_coefficients[k];
    odd = odd * square + segment_coefficients[k - 1];
  }
  even = even * square + segment_coefficients[0];
  return z * std::sqrt(z) * (even + odd * x);
}

}  // namespace

double lens_area(double r, double s, double distance) {
  const double small = s < r ? s : r;
  const double large = s < r ? r : s;
  // Each rounded but once where it is small, since what is subtracted first is exact (Sterbenz):
  // distance - large between outer contact and half the large radius, large - small for radii
  // alike.
  const double beyond = distance - large;
  const double overlap = small - beyond;
  if (overlap <= 0.0) return 0.0;
  const double small_beyond = 2.0 * distance >= large ? small + beyond : distance - (large - small);
  if (small_beyond <= 0.0) return std::numbers::pi * small * small;
  const double large_beyond =
      large <= 2.0 * small ? (large - small) + distance : large + (distance - small);
  const double around = small + large + distance;
  // Both divisors, 4 small distance and 4 large distance, from one division: it takes the most
  // time.
  const double scale = 1.0 / (4.0 * small * large * distance);
  const double small_scale = small * scale, large_scale = large * scale;
  const double z_small = large_beyond * overlap * large_scale;
  const double z_rest = around * small_beyond * large_scale;  // 1 - z_small
  const double z_large = small_beyond * overlap * small_scale;
  const double of_small =
      z_small > 0.5 ? 2.0 * std::numbers::pi - segment(z_rest) : segment(z_small);
  return 0.5 * (small * small * of_small + large * large * segment(z_large));
}

void lens_areas(std::span<const double> r, std::span<const double> s,
                std::span<const double> distance, std::span<double> area) {
  PHYTOBENCH_EXPECT(r.size() == s.size() && r.size() == distance.size() && r.size() == area.size());
  HWY_DYNAMIC_DISPATCH(lenses)(r.data(), s.data(), distance.data(), area.data(), r.size());
}

}  // namespace phytobench
#endif
