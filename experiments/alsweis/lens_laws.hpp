// SPDX-License-Identifier: MIT
// Laws of the area that two discs have in common, and by how much a computed one may break them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random/counter_stream.hpp"

namespace phytobench::experiments::alsweis {

/// Two circles that cross: |r - s| < distance < r + s.
struct CrossingCircles {
  double r, s, distance;

  double smaller() const { return std::min(r, s); }
};

/// Radii of 0.01 to 1.01, at least a thousandth of the way off either contact.
inline CrossingCircles random_crossing(CounterStream& stream) {
  const double r = 0.01 + stream.next_unit(), s = 0.01 + stream.next_unit();
  const double low = std::abs(r - s);
  return {r, s, low + (0.001 + 0.998 * stream.next_unit()) * (r + s - low)};
}

/// Largest relative error of one rounding.
inline constexpr double rounding = 0x1p-53;
/// What lens_area() states of itself: relative error, for the arguments as they are.
inline constexpr double area_error = 1e-14;

/// By Heron's formula.
inline double common_chord(const CrossingCircles& c) {
  const auto [r, s, d] = c;
  return std::sqrt((r + s - d) * (r + s + d) * (d - r + s) * (d + r - s)) / d;
}

/// How many times its own size a relative change of radii and distance, each up or down, has in the
/// area A: (r dA/dr + s dA/ds + d |dA/dd|) / A. The derivatives by the radii are the lengths of the
/// arcs, that by the distance is minus the chord; since A is homogeneous of degree 2, the first two
/// terms are 2 A + d chord (Euler). About 3 d over the thickness of a thin lens.
inline double lens_condition(const CrossingCircles& c, double area) {
  return 2.0 + 2.0 * c.distance * common_chord(c) / area;
}

/// Bound of |area(k r, k s, k d) / (k^2 area(r, s, d)) - 1| for a k that rounds: one rounding of
/// each argument, the errors of two areas, and two roundings of the quotient. To first order in
/// `rounding`; the rest is below 1e-9 of it for random_crossing().
inline double scaling_bound(const CrossingCircles& c, double area) {
  return rounding * lens_condition(c, area) + 2.0 * area_error + 2.0 * rounding;
}

/// Bound of the error of the chord 2 r sin(theta / 2), theta = 2 acos((r^2 + d^2 - s^2) / (2 r d))
/// after [Alsweis] (A.2): at most three roundings of every square and two of the quotient, arc
/// cosine and sine right to two roundings each. The arc cosine divides the error of its argument by
/// chord / (2 r): that is what thin lenses lose.
inline double chord_bound(const CrossingCircles& c) {
  const auto [r, s, d] = c;
  const double x = (r * r + d * d - s * s) / (2.0 * r * d), sine = common_chord(c) / (2.0 * r);
  const double x_error =
      rounding * (3.0 * (r * r + d * d + s * s) / (2.0 * r * d) + 2.0 * std::abs(x));
  const double angle_error = x_error / sine + 2.0 * rounding * std::acos(x);
  return 2.0 * r * (std::abs(x) * angle_error + 4.0 * rounding * sine);
}

/// Keeps the larger; what is no number breaks every law.
inline void keep_larger(double& largest, double value) {
  largest = std::isnan(value) ? HUGE_VAL : std::max(largest, value);
}

/// Largest violations among random pairs. What is "over its bound" must not exceed 1.
struct LensViolations {
  double asymmetry = 0.0;
  double scaling_by_powers_of_two = 0.0;  ///< relative; exact arithmetic: 0
  double scaling_by_three_over_bound = 0.0;
  double largest_condition = 0.0;
  double rise_with_distance = 0.0;      ///< relative
  double excess_over_small_disc = 0.0;  ///< relative
  double step_over_bound = 0.0;         ///< across the distances where formulas change
};

/// The area's slope is minus the chord, no longer than the smaller disc's diameter: so much it may
/// change across a short way, and no more where it goes over to another formula.
template <class Area>
double step_over_bound(const Area& area, const CrossingCircles& c) {
  constexpr double way = 1e-9;
  double worst = 0.0;
  for (const double seam : {std::abs(c.r - c.s), c.smaller(), c.r + c.s}) {
    const double near = seam * (1.0 - way), far = seam * (1.0 + way);
    const double before = area(c.r, c.s, near), behind = area(c.r, c.s, far);
    const double bound = 2.0 * c.smaller() * (far - near) + 2.0 * area_error * before;
    keep_larger(worst, std::abs(behind - before) / bound);
  }
  return worst;
}

/// `area` takes two radii and a distance.
template <class Area>
LensViolations lens_violations(const Area& area, CounterStream& stream, int pairs) {
  LensViolations worst;
  for (int i = 0; i < pairs; ++i) {
    const CrossingCircles c = random_crossing(stream);
    const auto [r, s, d] = c;
    const double a = area(r, s, d), disc = std::numbers::pi * c.smaller() * c.smaller();
    keep_larger(worst.asymmetry, std::abs(a - area(s, r, d)));
    for (const double k : {0x1p-20, 0.5, 4.0, 0x1p20})
      keep_larger(worst.scaling_by_powers_of_two,
                  std::abs(area(k * r, k * s, k * d) / (k * k * a) - 1.0));
    keep_larger(worst.scaling_by_three_over_bound,
                std::abs(area(3.0 * r, 3.0 * s, 3.0 * d) / (9.0 * a) - 1.0) / scaling_bound(c, a));
    keep_larger(worst.largest_condition, lens_condition(c, a));
    keep_larger(worst.rise_with_distance, area(r, s, d * (1.0 + 1e-9)) / a - 1.0);
    keep_larger(worst.excess_over_small_disc, a / disc - 1.0);
    keep_larger(worst.step_over_bound, step_over_bound(area, c));
  }
  return worst;
}

}  // namespace phytobench::experiments::alsweis
