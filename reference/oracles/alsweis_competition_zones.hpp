// SPDX-License-Identifier: MIT
// Competition above and below ground of [Alsweis] ch. 5, literally: (5.1) to (5.9). Shares no code
// with core/. Sums over neighbours j are the caller's.
#pragma once

#include <cmath>
#include <numbers>

#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::oracles::alsweis::competition {

inline double disc_area_of(double radius) {
  return std::numbers::pi * radius * radius;
}

// (5.1), the summand of one neighbour.
inline double equation_5_1(double gamma_ij, double A_i) {
  return gamma_ij / (2.0 * A_i);
}

// (5.2): what plant i loses. Equal circles: "gamma_ij or 0", see (4.3).
inline double equation_5_2(double A_i, double A_j, double gamma_ij, double of_equals = 0.5) {
  if (A_i < A_j) return gamma_ij;
  if (A_i > A_j) return 0.0;
  return of_equals * gamma_ij;
}

// F(i, j): "the index of the zone of the overlap", 1 (inside) to 5. The text prints no radii: here
// five rings of equal width around the larger plant, of which the innermost counts that the smaller
// one reaches.
inline int zone_index_F(double distance, double radius_i, double radius_j) {
  const double larger = std::fmax(radius_i, radius_j), smaller = std::fmin(radius_i, radius_j);
  for (int F = 1; F < 5; ++F)
    if (distance - smaller <= F * larger / 5.0) return F;
  return 5;
}

// (5.3) for zones 4 and 5, (5.4) for zones 1 to 3: the summand of one neighbour.
inline double equation_5_3(double beta_ij, int F, double A_i) {
  return 3.0 * beta_ij / F / A_i;
}
inline double equation_5_4(double beta_ij, double A_i) {
  return beta_ij / A_i;
}
inline double equations_5_3_and_5_4(double beta_ij, int F, double A_i) {
  return F >= 4 ? equation_5_3(beta_ij, F, A_i) : equation_5_4(beta_ij, A_i);
}

// The overlap in ring F alone: what the disc out to its outer rim shares, less what the disc out to
// its inner rim does.
inline double overlap_in_ring(int F, double distance, double smaller, double larger) {
  const double outer = equation_a4_corrected(smaller, larger * F / 5.0, distance);
  return F == 1 ? outer : outer - equation_a4_corrected(smaller, larger * (F - 1) / 5.0, distance);
}

// Not in the text: every part of the overlap weighted by the ring it lies in, as the caption of
// figure 5.3 c has it. Loss of the smaller plant of a pair; continuous in the distance.
inline double ringwise_5_3_and_5_4(double distance, double smaller, double larger) {
  double sum = 0.0;
  for (int F = 1; F <= 5; ++F)
    sum += equations_5_3_and_5_4(overlap_in_ring(F, distance, smaller, larger), F,
                                 disc_area_of(smaller));
  return sum;
}

// (5.5), and (7.5), which repeats it.
inline double equation_5_5(double p, double alpha_i, double sigma_i) {
  return p * alpha_i + (1.0 - p) * sigma_i;
}

// (5.6), signs from {-1, 0, 1}; s1 = 1 harms.
inline double equation_5_6(double s1, double s2, double p, double alpha_i, double sigma_i) {
  return s1 * p * alpha_i + s2 * (1.0 - p) * sigma_i;
}

// Letter of table 5.1 for a sign: N harms, T does nothing, P helps.
inline char table_5_1_letter(double sign) {
  return sign > 0.0 ? 'N' : sign < 0.0 ? 'P' : 'T';
}

// (5.7).
inline double equation_5_7(double phi_i) {
  return phi_i <= 0.5 ? 1.0 - 2.0 * phi_i : 0.0;
}

// (5.8).
inline double equation_5_8(double MGR, double R_basal, double R_max) {
  return MGR * R_basal / R_max * (1.0 - R_basal / R_max);
}

// (5.9).
inline double equation_5_9(double GR, double C) {
  return GR * C;
}

}  // namespace phytobench::oracles::alsweis::competition
