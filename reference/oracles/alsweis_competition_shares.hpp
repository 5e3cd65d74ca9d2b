// SPDX-License-Identifier: MIT
// Zones and shares of [Alsweis] ch. 4, literally: (4.1) to (4.4). Shares no code with core/, so
// that agreement means something. Areas gamma_ij come from alsweis_overlap.hpp.
#pragma once

#include <cmath>

namespace phytobench::oracles::alsweis::competition {

// (4.1): R_FON = d R_basal^b.
inline double equation_4_1(double d, double R_basal, double b) {
  return d * std::pow(R_basal, b);
}

// (4.2): what each of two plants gets of the overlap, and what each loses.
inline double equation_4_2(double gamma_ij) {
  return gamma_ij / 2.0;
}

// (4.3): what plant i gets of the overlap; f are the areas of both circles. Where they are equal
// the text allows "gamma_ij or 0": `of_equals`, 1 or 0 as printed, 1/2 as it has to be for (4.3) to
// share out the overlap once.
inline double equation_4_3_as_printed(double f_i, double f_j, double gamma_ij,
                                      double of_equals = 0.5) {
  if (f_i > f_j) return gamma_ij;
  if (f_i < f_j) return 0.0;
  return of_equals * gamma_ij;
}

// What plant i loses, as "only the small plants are affected" and (5.2) want it.
inline double equation_4_3_corrected(double f_i, double f_j, double gamma_ij,
                                     double of_equals = 0.5) {
  return gamma_ij - equation_4_3_as_printed(f_i, f_j, gamma_ij, of_equals);
}

// (4.4), for one neighbour j.
inline double equation_4_4(double p, double alpha_ij, double sigma_ij) {
  return p * alpha_ij + (1.0 - p) * sigma_ij;
}

// The three sentences below (4.4): "if p is less than 0.5, the asymmetric competition is the
// stronger". The weight that alpha would need for them, and the weight it has in the formula.
inline double sentence_4_4_as_printed(double p) {
  return 1.0 - p;
}
inline double sentence_4_4_corrected(double p) {
  return p;
}

// "If p equals 0.5, both have a similar influence": by how much the asymmetric part exceeds the
// symmetric one, in weights, and in what the smaller plant of a pair loses of their overlap.
inline double balance_4_4_as_printed(double p) {
  return p - (1.0 - p);
}
inline double balance_4_4_corrected(double p) {
  return equation_4_4(p, equation_4_3_corrected(1.0, 2.0, 1.0), 0.0) -
         equation_4_4(p, 0.0, equation_4_2(1.0));
}

}  // namespace phytobench::oracles::alsweis::competition
