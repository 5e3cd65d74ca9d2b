// SPDX-License-Identifier: MIT
// Two functions that keep growth laws in one piece where their shape passes 1: written with powers
// they would divide 0 by 0 there and lose digits nearby.
#pragma once

#include <cmath>

namespace phytobench {

/// (e^z - 1) / z, and 1 at 0. Falls to 0 for z -> -infinity.
inline double exponential_quotient(double z) {
  return z == 0.0 ? 1.0 : std::expm1(z) / z;
}

/// log(1 + u) / u, and 1 at 0. For u > -1.
inline double logarithm_quotient(double u) {
  return u == 0.0 ? 1.0 : std::log1p(u) / u;
}

/// log(size / unit) without losing digits where both are nearly equal. For sizes > 0.
inline double log_ratio(double size, double unit) {
  const double ratio = size / unit;
  return ratio > 0.5 && ratio < 2.0 ? std::log1p((size - unit) / unit) : std::log(ratio);
}

}  // namespace phytobench
