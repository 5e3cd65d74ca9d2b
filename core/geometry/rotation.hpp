// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "core/geometry/vector3.hpp"

namespace phytobench {

/// Some unit vector at right angles to the unit vector `v`, for cases in which no plane is given.
inline Vector3 any_perpendicular(const Vector3& v) {
  const Vector3 other = std::abs(v.x) < 0.9 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 0.0, 1.0};
  const Vector3 across = cross(v, other);
  return across / norm(across);
}

/// A rotation of space, as a unit quaternion w + (x, y, z).
class Rotation {
 public:
  /// The identity.
  constexpr Rotation() = default;

  /// By `angle_rad` about `axis` (unit length), counter-clockwise seen from its tip.
  static Rotation about(const Vector3& axis, double angle_rad) {
    return {std::cos(0.5 * angle_rad), std::sin(0.5 * angle_rad) * axis};
  }

  /// The smallest rotation that takes `from` to `to` (both of unit length): about their vector
  /// product by the angle between them ([Brzoska2019] eq. 3). Where they are opposite, the thesis
  /// gives no axis: a half turn about some perpendicular one.
  static Rotation between(const Vector3& from, const Vector3& to) {
    const Vector3 across = cross(from, to);
    const double along = dot(from, to);
    constexpr double no_plane = 1e-24;
    if (squared_norm(across) < no_plane && along < 0.0) return {0.0, any_perpendicular(from)};
    // 1 + along, without the cancellation that costs half the digits near the opposite.
    return Rotation(0.5 * squared_norm(from + to), across).normalised();
  }

  /// Uniform over all rotations, from three independent numbers in [0, 1) (Shoemake 1992).
  static Rotation uniform(double u1, double u2, double u3) {
    const double a = std::sqrt(1.0 - u1), b = std::sqrt(u1);
    const double t = 2.0 * std::numbers::pi * u2, s = 2.0 * std::numbers::pi * u3;
    return {b * std::cos(s), {a * std::sin(t), a * std::cos(t), b * std::sin(s)}};
  }

  double w() const { return w_; }
  const Vector3& axial() const { return axial_; }  ///< sin(angle / 2) times the axis

  Vector3 operator()(const Vector3& v) const {
    const Vector3 twice = 2.0 * cross(axial_, v);
    return v + w_ * twice + cross(axial_, twice);
  }

  /// First `second`, then `first`.
  friend Rotation operator*(const Rotation& first, const Rotation& second) {
    return Rotation(first.w_ * second.w_ - dot(first.axial_, second.axial_),
                    first.w_ * second.axial_ + second.w_ * first.axial_ +
                        cross(first.axial_, second.axial_))
        .normalised();
  }

  friend bool operator==(const Rotation&, const Rotation&) = default;

 private:
  Rotation(double w, const Vector3& axial) : w_(w), axial_(axial) {}

  /// Takes off what rounding has added to its length.
  Rotation normalised() const {
    const double length = std::sqrt(w_ * w_ + squared_norm(axial_));
    return {w_ / length, axial_ / length};
  }

  double w_ = 1.0;
  Vector3 axial_;
};

}  // namespace phytobench
