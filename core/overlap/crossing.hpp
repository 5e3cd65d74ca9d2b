// SPDX-License-Identifier: MIT
// Where two circles cross, and the pieces of circles between crossings.
#pragma once

#include <cmath>
#include <numbers>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// Increases with the angle of a direction, from 0 along x to below 4; opposite directions differ
/// by exactly 2. For sorting, without arc functions.
inline double turn_key(const Point2& v) {
  const double along = v.x / (std::abs(v.x) + std::abs(v.y));
  return v.y >= 0.0 ? 1.0 - along : 3.0 + along;
}

/// Both points at which two circles cross, from the center of the first: the arc of the first
/// circle inside the second disc runs counter-clockwise from `enter` to `exit`.
struct Crossing {
  Point2 enter, exit;
};

/// `between` leads from the first center to the second, whose distance is `distance`. The circles
/// must cross. The smaller circle should come first: its points are right to its own last digits.
inline Crossing crossing_of(double r, double s, const Point2& between, double distance) {
  const Point2 along = (1.0 / distance) * between;
  // Of a small circle both distance - s and s are many of its radii, of two alike r - s is exact.
  const double chord_at = r < 0.5 * s ? 0.5 * ((distance - s) * (distance + s) + r * r) / distance
                                      : 0.5 * (distance + (r - s) / distance * (r + s));
  // Heron's formula with differences that do not cancel: from the longest side down, as Kahan
  // writes it. Below 0 only by rounding at a touch.
  const double small = s < r ? s : r, large = s < r ? r : s;
  const double shortest = distance < small ? distance : small;
  const double middle_side = distance < small ? small : distance < large ? distance : large;
  const double longest = distance < large ? large : distance;
  const double rest = longest - middle_side;
  const double product = (longest + (middle_side + shortest)) * (shortest - rest) *
                         (shortest + rest) * (longest + (middle_side - shortest));
  const double half = product > 0.0 ? std::sqrt(product) / (2.0 * distance) : 0.0;
  const Point2 middle = chord_at * along, across{-half * along.y, half * along.x};
  return {middle - across, middle + across};
}

/// Counter-clockwise angle from p to q, 0 to 2 pi. `turned` is the same as a difference of turn
/// keys, 0 to 4: it tells nothing from a whole turn, where rounding would not.
inline double angle_between(const Point2& p, const Point2& q, double turned) {
  const double angle = std::atan2(cross(p, q), dot(p, q));
  constexpr double quarter = 0.5 * std::numbers::pi, whole = 2.0 * std::numbers::pi;
  if (turned > 2.0) return angle <= quarter ? angle + whole : angle;
  return angle >= -quarter ? angle : angle + whole;
}

/// Area between an arc of that angle and its chord.
inline double segment_area(double radius, double angle) {
  constexpr double small = 0.5;
  double difference = angle - std::sin(angle);
  if (std::abs(angle) < small) {
    const double a2 = angle * angle;
    difference =
        angle * a2 / 6.0 *
        (1.0 - a2 / 20.0 *
                   (1.0 - a2 / 42.0 * (1.0 - a2 / 72.0 * (1.0 - a2 / 110.0 * (1.0 - a2 / 156.0)))));
  }
  return 0.5 * radius * radius * difference;
}

}  // namespace phytobench
