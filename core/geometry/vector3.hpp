// SPDX-License-Identifier: MIT
// A point or vector in space. y points up. Our own plain struct, because every engine and oracle
// must round every sum in the same order: a library's vectorised dot product may not.
#pragma once

#include <cmath>

namespace phytobench {

struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

constexpr Vector3 operator*(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

constexpr Vector3 operator/(const Vector3& v, double divisor) {
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}

/// Component by component ([Brzoska2019] sec. 4.1: the tropism weights).
constexpr Vector3 hadamard_product(const Vector3& a, const Vector3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

constexpr double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr double squared_norm(const Vector3& v) {
  return dot(v, v);
}

inline double norm(const Vector3& v) {
  return std::sqrt(squared_norm(v));
}

/// The one squared distance of the suite, [Brzoska2019] eq. 24: all engines use it, so that equal
/// inputs give equal bits and ties are the same ties everywhere.
constexpr double squared_distance(const Vector3& a, const Vector3& b) {
  return squared_norm(a - b);
}

inline bool is_finite(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace phytobench
