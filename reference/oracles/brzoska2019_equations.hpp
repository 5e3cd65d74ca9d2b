// SPDX-License-Identifier: MIT
// The printed equations of [Brzoska2019], literally, and beside each misprint the corrected form.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace phytobench::oracles::brzoska2019 {

struct Point {
  double x, y, z;
};

inline Point plus(Point a, Point b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point minus(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point times(double s, Point a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Point over(Point a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline double scalar_product(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point vector_product(Point a, Point b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Point a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

// Eq. 8: the new node stands D from its parent.
inline Point equation_8(Point v, double D, Point n_hat) {
  return plus(v, times(D, n_hat));
}

// Eq. 9, the sum: unit vectors to the attraction points S(v).
inline Point equation_9_sum(Point v, const std::vector<Point>& S) {
  Point n{0, 0, 0};
  for (Point s : S) n = plus(n, over(minus(s, v), length(minus(s, v))));
  return n;
}

// The sentence before eq. 8, taken at its word: the vectors themselves are added.
inline Point sentence_before_equation_8_sum(Point v, const std::vector<Point>& S) {
  Point n{0, 0, 0};
  for (Point s : S) n = plus(n, minus(s, v));
  return n;
}

// Eq. 9, normalised. 0/0 for a zero sum, which the thesis does not mention.
inline Point equation_9(Point sum) {
  return over(sum, length(sum));
}

// Eq. 10 as printed: n is made a unit vector before tropism joins it.
inline Point equation_10_as_printed(Point sum, Point g) {
  Point n_hat = equation_9(sum);
  return over(plus(n_hat, g), length(plus(n_hat, g)));
}

// Eq. 10 as the published trees need it: tropism joins the sum.
inline Point equation_10_corrected(Point sum, Point g) {
  return over(plus(sum, g), length(plus(sum, g)));
}

// Fig. 33 and the missing eq. 16.
inline double sig(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

// Eq. 17 as printed. n = 1 divides by zero.
inline double equation_17_as_printed(double begin, double end, double sig_min, double sig_max,
                                     int n, int i) {
  return begin - sig(sig_min + (sig_max - sig_min) / (n - 1) * i) * (begin - end);
}

// Eq. 17 as the published trees need it: the squares are interpolated; n = 1 stays at the
// beginning.
inline double equation_17_corrected(double begin, double end, double sig_min, double sig_max, int n,
                                    int i) {
  if (n == 1) return begin;
  double x = sig_min + (sig_max - sig_min) / (n - 1) * i;
  return std::sqrt(begin * begin - sig(x) * (begin * begin - end * end));
}

// Volume of the unit ball between the planes y = a and y = b by the formula for a spherical
// segment, pi h / 6 (3 r1^2 + 3 r2^2 + h^2); the thesis names V_base without a formula.
inline double base_volume(double cutoff_bottom, double cutoff_top) {
  double a = -1 + 2 * cutoff_bottom;
  double b = 1 - 2 * cutoff_top;
  double h = b - a;
  double r1_squared = 1 - a * a;
  double r2_squared = 1 - b * b;
  return std::numbers::pi * h / 6 * (3 * r1_squared + 3 * r2_squared + h * h);
}

// Eq. 21.
inline double equation_21(double determinant, double v_base) {
  return determinant * v_base;
}

// Eq. 22 as printed: a density in the denominator.
inline double equation_22_as_printed(double v_target, double rho) {
  return v_target / rho;
}

// Eq. 22 corrected: volume times density, rounded up to whole points.
inline double equation_22_corrected(double v_target, double rho) {
  return std::ceil(v_target * rho);
}

// Eq. 23 and 24.
inline double equation_24(Point p, Point q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
}
inline double equation_23(Point p, Point q) {
  return std::sqrt(equation_24(p, q));
}

}  // namespace phytobench::oracles::brzoska2019
