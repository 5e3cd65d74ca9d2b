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

// Eq. 1: a point of the unit circle.
inline Point equation_1(double alpha_rad) {
  return {std::cos(alpha_rad), 0, std::sin(alpha_rad)};
}

// Eq. 2: corner i of w.
inline Point equation_2(int i, int w) {
  return equation_1(static_cast<double>(i) / w * 360 * std::numbers::pi / 180);
}

// Rotation of p about the unit vector k by beta (Rodrigues).
inline Point rotated(Point p, Point k, double beta_rad) {
  double c = std::cos(beta_rad), s = std::sin(beta_rad);
  return plus(plus(times(c, p), times(s, vector_product(k, p))),
              times((1 - c) * scalar_product(k, p), k));
}

// Eq. 3 as printed: about s = u x n by the angle between u and n. 0/0 for n = u and n = -u, which
// the thesis does not mention.
inline Point equation_3_as_printed(Point p, Point n) {
  Point u{0, 1, 0};
  Point s = vector_product(u, n);
  double beta = std::acos(scalar_product(u, n) / (length(u) * length(n)));
  return rotated(p, over(s, length(s)), beta);
}

// Eq. 3 with the missing cases: nothing to turn, or half a turn about any horizontal axis.
inline Point equation_3_corrected(Point p, Point n) {
  Point u{0, 1, 0};
  if (length(vector_product(u, n)) > 0) return equation_3_as_printed(p, n);
  return n.y > 0 ? p : rotated(p, {0, 0, 1}, std::numbers::pi);
}

// Sec. 2.2, steps 1 to 4: corner i of a ring about K.
inline Point ring_corner(Point K, double r, Point n, int i, int w) {
  return plus(times(r, equation_3_corrected(equation_2(i, w), n)), K);
}

// Eq. 11 and 12.
inline double equation_11(double r1, double r2, double n) {
  return std::pow(std::pow(r1, n) + std::pow(r2, n), 1 / n);
}
inline double equation_12(const std::vector<double>& r, double n) {
  double sum = 0;
  for (double r_i : r) sum += std::pow(r_i, n);
  return std::pow(sum, 1 / n);
}

// Eq. 13, in degrees.
inline double equation_13(double theta_deg, double lambda) {
  return lambda * (1 - theta_deg / 180) * theta_deg;
}

}  // namespace phytobench::oracles::brzoska2019
