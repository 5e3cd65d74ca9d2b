// SPDX-License-Identifier: MIT
// Appendices B and C of [Alsweis], literally, and beside each misprint the corrected form. Shares
// no code with core/, so that agreement means something.
#pragma once

#include <array>
#include <cmath>

namespace phytobench::oracles::alsweis {

// z_1 .. z_9, row by row, at 0 .. 8.
using Neighbourhood = std::array<double, 9>;

// The masks of figure B.1: the sums in the first and in the second braces of (B.1).
inline double mask_G_x(const Neighbourhood& z) {
  return (z[6] + 2 * z[7] + z[8]) - (z[0] + 2 * z[1] + z[2]);
}
inline double mask_G_y(const Neighbourhood& z) {
  return (z[2] + 2 * z[5] + z[8]) - (z[0] + 2 * z[3] + z[6]);
}

// (B.1), second line: said to be the first line written out, whose root it lacks.
inline double equation_b1_second_line(const Neighbourhood& z) {
  return mask_G_x(z) * mask_G_x(z) + mask_G_y(z) * mask_G_y(z);
}

// (B.1), first line.
inline double equation_b1_first_line(const Neighbourhood& z) {
  return std::sqrt(mask_G_x(z) * mask_G_x(z) + mask_G_y(z) * mask_G_y(z));
}

// The listing of appendix C.
inline double cosine_interpolant(double a, double b, double x) {
  const double ft = x * 3.1415927;
  const double f = (1 - std::cos(ft)) * .5;
  return a * (1 - f) + b * f;
}

// The other standard interpolation that appendix C names.
inline double linear_interpolant(double a, double b, double x) {
  return a * (1 - x) + b * x;
}

// Random values a, b, c at neighbouring knots: the slope behind the knot of b less that before it.
// By the text, which lets every such function be differentiated everywhere, it is zero.
inline double slope_jump_as_told() {
  return 0;
}
inline double slope_jump_of_linear(double a, double b, double c) {
  return (c - b) - (b - a);
}

// The noise of appendix C at a knot with random value a, and what Perlin's has there: the product
// of a random gradient with the way from the knot, which is zero.
inline double noise_at_knot(double a, double b) {
  return cosine_interpolant(a, b, 0);
}
inline double perlin_noise_at_knot(double gradient) {
  return gradient * 0;
}

}  // namespace phytobench::oracles::alsweis
