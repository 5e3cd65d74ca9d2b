// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/rotation.hpp"
#include "core/geometry/vector3.hpp"

namespace phytobench {

/// A place with directions and a size: the local coordinate system of [Lintermann1997] sec. 3.2.
/// Components grow along y (the suite's "up"; the paper's z). The axes have unit length and are
/// right-handed: cross(x, y) = z.
struct Frame {
  Vector3 origin;
  Vector3 x{1.0, 0.0, 0.0};
  Vector3 y{0.0, 1.0, 0.0};
  Vector3 z{0.0, 0.0, 1.0};
  double scale = 1.0;  ///< lengths in this frame are so many times longer outside, > 0

  /// A place given in this frame, seen from outside.
  Vector3 place(const Vector3& local) const { return origin + scale * direction(local); }

  /// The same for a direction, which keeps its length.
  Vector3 direction(const Vector3& local) const { return local.x * x + local.y * y + local.z * z; }

  /// A direction from outside, seen in this frame; the inverse of direction().
  Vector3 local_direction(const Vector3& outside) const {
    return {dot(outside, x), dot(outside, y), dot(outside, z)};
  }

  /// A place from outside, seen in this frame; the inverse of place().
  Vector3 local_place(const Vector3& outside) const {
    return local_direction(outside - origin) / scale;
  }

  /// The same place and scale, with the axes turned by a rotation given outside.
  Frame turned(const Rotation& rotation) const {
    return {origin, rotation(x), rotation(y), rotation(z), scale};
  }

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// `inner`, given in `outer`, seen from outside.
inline Frame operator*(const Frame& outer, const Frame& inner) {
  return {outer.place(inner.origin), outer.direction(inner.x), outer.direction(inner.y),
          outer.direction(inner.z), outer.scale * inner.scale};
}

/// Axes of unit length at right angles again, after many turns: y keeps its direction, x its plane.
inline Frame orthonormal(const Frame& frame) {
  const Vector3 y = frame.y / norm(frame.y);
  const Vector3 across = frame.x - dot(frame.x, y) * y;
  const Vector3 x = across / norm(across);
  return {frame.origin, x, y, cross(x, y), frame.scale};
}

}  // namespace phytobench
