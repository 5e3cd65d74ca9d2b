// SPDX-License-Identifier: MIT
// Light, roots, illness and nurses of [Alsweis] ch. 7, literally, as printed and as corrected:
// (7.1) to (7.6). Shares no code with core/. Sums over neighbours j are the caller's.
#pragma once

#include <cmath>

#include "reference/oracles/alsweis_competition_zones.hpp"

namespace phytobench::oracles::alsweis::competition {

// (7.1), the summand of one neighbour; k is not published.
inline double equation_7_1(double k, double beta_ij, int F, double A_i) {
  return k * beta_ij / F / A_i;
}

// (7.2): every plant of a pair loses this, whichever is the larger.
inline double equation_7_2_as_printed(double q, double L_fac, double gamma_ij) {
  return (q + L_fac) * gamma_ij / (2.0 * q);
}

// Only the smaller plant does; the larger loses what is left of the overlap, so that L_fac = 0
// halves it and L_fac = q leaves all of it to the larger. Equal circles halve it; or one of them
// counts as the larger, see (5.2).
inline double equation_7_2_corrected(double q, double L_fac, double gamma_ij, double A_i,
                                     double A_j, double of_equals = 0.5) {
  const double smaller = (q + L_fac) * gamma_ij / (2.0 * q);
  const double larger = (q - L_fac) * gamma_ij / (2.0 * q);
  if (A_i < A_j) return smaller;
  if (A_i > A_j) return larger;
  return of_equals * smaller + (1.0 - of_equals) * larger;
}

// (7.3). T_f has no index in print; whose it is, is the caller's reading.
inline double equation_7_3(double gamma_ij, double A_i, double T_f, double m) {
  return gamma_ij / (2.0 * A_i) * (1.0 + T_f / m);
}

// T_f of a pair from the ranks of both root systems (0 flat, 0.5 medium, 1 deep). One number for
// both: deep against flat must be half of deep against deep, so the shallower one counts.
inline double T_f_as_printed(double own_rank, double rank_of_neighbour, double m) {
  return m * std::fmin(own_rank, rank_of_neighbour);
}

// That of the plant which takes.
inline double T_f_corrected(double rank_of_neighbour, double m) {
  return m * rank_of_neighbour;
}

// (7.4), T_k of the neighbour.
inline double equation_7_4(double gamma_ij, double A_i, double T_k, double s) {
  return gamma_ij / (2.0 * A_i) * (1.0 + T_k / s);
}

// T_k in [0, 2 s], "falls gradually with time"; no law is printed: linear over `duration` steps.
inline double T_k_as_printed(double s, double steps_since, double duration) {
  return 2.0 * s * std::fmax(0.0, 1.0 - steps_since / duration);
}

// From 0, as if healthy, to -s, where the healthy plant is free of it.
inline double T_k_corrected(double s, double steps_since, double duration) {
  return -s * std::fmin(1.0, steps_since / duration);
}

// (7.5): (5.5) again. The sentence below it names p the share of the competition for nutrients.
inline double equation_7_5(double p, double alpha_i, double sigma_i) {
  return p * alpha_i + (1.0 - p) * sigma_i;
}
inline double nutrient_share_7_5_as_printed(double p) {
  return p;
}
inline double nutrient_share_7_5_corrected(double p) {
  return equation_7_5(p, 0.0, 1.0);
}

// (7.6): roots help, shade harms.
inline double equation_7_6_as_printed(double p, double alpha_i, double sigma_i) {
  return p * alpha_i - (1.0 - p) * sigma_i;
}

// What section 7.4 tells: shade helps.
inline double equation_7_6_as_told(double p, double alpha_i, double sigma_i) {
  return -p * alpha_i + (1.0 - p) * sigma_i;
}

}  // namespace phytobench::oracles::alsweis::competition
