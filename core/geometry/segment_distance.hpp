// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "core/geometry/vector3.hpp"

namespace phytobench {

/// The straight line between two points, which may coincide.
struct Segment {
  Vector3 from;
  Vector3 to;
};

/// Squared distance between the nearest points of two segments, 0 where they cross (Ericson 2005,
/// Real-Time Collision Detection, sec. 5.1.9). Coordinates must be finite.
inline double squared_distance(const Segment& a, const Segment& b) {
  const Vector3 along_a = a.to - a.from, along_b = b.to - b.from, between = a.from - b.from;
  const double aa = squared_norm(along_a), bb = squared_norm(along_b), ab = dot(along_a, along_b);
  const double a_between = dot(along_a, between), b_between = dot(along_b, between);
  const auto share = [](double part, double whole) {
    return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
  };
  // Where on a, as a share of its length; any place will do if the two are parallel.
  double s = share(ab * b_between - a_between * bb, aa * bb - ab * ab);
  // The place on b nearest to it, and if that is beyond an end of b, the place on a nearest to that
  // end.
  const double t = share(ab * s + b_between, bb);
  s = share(ab * t - a_between, aa);
  return squared_norm(between + s * along_a - t * along_b);
}

}  // namespace phytobench
