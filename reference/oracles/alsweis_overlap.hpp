// SPDX-License-Identifier: MIT
// Appendix A of [Alsweis], literally, and beside it the textbook form. Shares no code with core/,
// so that agreement means something.
#pragma once

#include <cmath>
#include <numbers>

namespace phytobench::oracles::alsweis {

// (A.2), (A.3): the opening angle that the common chord has at the centre of circle i.
inline double equation_a2(double r_i, double r_j, double d) {
  return 2.0 * std::acos((r_i * r_i + d * d - r_j * r_j) / (2.0 * r_i * d));
}

// (A.4) for r_i < r_j. NaN where an angle of the second case does not exist.
inline double equation_a4_as_printed(double r_i, double r_j, double d) {
  if (d >= r_i + r_j) return 0.0;
  if (d <= r_i) return std::numbers::pi * r_i * r_i;
  const double theta_i = equation_a2(r_i, r_j, d);
  const double theta_j = equation_a2(r_j, r_i, d);
  return r_i * r_i * (theta_i - std::sin(theta_i)) + r_j * r_j * (theta_j - std::sin(theta_j));
}

// The textbook's: half of the printed sum, and the small disc only where it lies inside.
inline double equation_a4_corrected(double r_i, double r_j, double d) {
  if (d >= r_i + r_j) return 0.0;
  const double r = std::fmin(r_i, r_j);
  if (d <= std::fabs(r_j - r_i)) return std::numbers::pi * r * r;
  const double theta_i = equation_a2(r_i, r_j, d);
  const double theta_j = equation_a2(r_j, r_i, d);
  return 0.5 *
         (r_i * r_i * (theta_i - std::sin(theta_i)) + r_j * r_j * (theta_j - std::sin(theta_j)));
}

}  // namespace phytobench::oracles::alsweis
