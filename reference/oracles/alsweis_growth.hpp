// SPDX-License-Identifier: MIT
// Growth of plants and the laws of density of [Alsweis], literally, and beside them what is meant.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace phytobench::oracles::alsweis::growth {

// (2.1), delta != 1.
inline double equation_2_1(double v, double k, double w, double delta) {
  return k / (1.0 - delta) * v * (std::pow(v / w, delta - 1.0) - 1.0);
}

// What it integrates to. Not printed.
inline double solution_of_2_1(double v_0, double k, double w, double delta, double t) {
  return w * std::pow(1.0 + (std::pow(w / v_0, delta - 1.0) - 1.0) * std::exp(-k * t),
                      -1.0 / (delta - 1.0));
}

// For delta = 1, which (2.1) leaves out: the logarithmic branch of 4.3 for one plant.
inline double gompertz_rate(double v, double k, double w) {
  return k * v * (std::log(w) - std::log(v));
}
inline double gompertz_solution(double v_0, double k, double w, double t) {
  return w * std::exp(std::log(v_0 / w) * std::exp(-k * t));
}

// Below (2.1): "the initial rate of growth". It is one per size, and holds for delta > 1 only.
inline double initial_rate_as_printed(double k, double delta) {
  return k / (delta - 1.0);
}
inline double relative_rate(double v, double k, double w, double delta) {
  return equation_2_1(v, k, w, delta) / v;
}

inline double equation_2_2(double x_0, double m_d) {
  return x_0 / (1.0 + m_d * x_0);
}

inline double equation_2_3(double x_0, double m_d, double m_i) {
  return m_i * x_0 / (1.0 + m_d * m_i * x_0);
}

inline double equation_2_4(double w, double b_0, double b_1) {
  return b_0 + b_1 * w;
}

inline double equation_2_5(double x, double alpha, double beta, double phi, double theta) {
  return std::pow(alpha + beta * std::pow(x, phi), -1.0 / theta);
}

inline double equation_2_15(double D_m, double b, double k) {
  return b * std::pow(D_m, -k);
}

// log w.
inline double equation_2_16(double D_m, double b, double k) {
  return std::log10(b) - k * std::log10(D_m);
}

// B, and what the text calls it.
inline double equation_2_17(double w, double D_m, double k) {
  return std::log10(w) + k * std::log10(D_m);
}
inline double meaning_of_B_as_printed(double D_m) {
  return std::log10(D_m);
}
inline double meaning_of_B_corrected(double b) {
  return std::log10(b);
}

// (4.5)
inline double equation_4_5(double v, double a) {
  return a == 0.0 ? 1.0 : std::pow(v, a);
}

// The bracket of the growth law in 4.3 with what stands before it, given the sum in it.
inline double section_4_3(double v_i, double sum, double k, double w_m, double delta, double a) {
  if (delta == 1.0) return k * equation_4_5(v_i, a) * (std::log(w_m) - std::log(sum));
  return k / (1.0 - delta) * equation_4_5(v_i, a) * (std::pow(sum / w_m, delta - 1.0) - 1.0);
}

// The sum over j as printed: over the others, each with the same phi_i.
inline double sum_4_3_as_printed(const std::vector<double>& v_j, double phi_i) {
  double sum = 0.0;
  for (const double v : v_j) sum += v * phi_i;
  return sum;
}

// Meant: each with its own share of plant i, and plant i itself with 1.
inline double sum_4_3_corrected(double v_i, const std::vector<double>& v_j,
                                const std::vector<double>& phi_ij) {
  double sum = v_i;
  for (std::size_t j = 0; j < v_j.size(); ++j) sum += v_j[j] * phi_ij[j];
  return sum;
}

// (4.2), (4.3), (4.4) of one neighbour. The area that plant i wins, as printed, and the area that
// it loses, as in chapter 5. Of two equal plants the one that is `first` wins all: "gamma or 0".
inline double phi_as_printed(double f_i, double f_j, double gamma_ij, double p, bool first) {
  const double alpha_ij = f_i > f_j || (f_i == f_j && first) ? gamma_ij : 0.0;
  return p * alpha_ij + (1.0 - p) * gamma_ij / 2.0;
}
inline double phi_corrected(double f_i, double f_j, double gamma_ij, double p, bool first) {
  return phi_as_printed(f_j, f_i, gamma_ij, p, !first);
}

struct TwoPlants {
  double v_1, v_2;
};

// Two plants that overlap altogether, gamma = 1, in explicit steps; a = 1, delta = 2. As printed
// phi is the gain of (4.3), compared anew at each step, and there is no term of the plant itself.
inline TwoPlants run_4_3(TwoPlants v, double k, double w, double p, double t, double step,
                         bool as_printed) {
  const auto phi = as_printed ? phi_as_printed : phi_corrected;
  const auto sum = [&](double own, double other, bool first) {
    const double pressed = other * phi(own, other, 1.0, p, first);
    return as_printed ? pressed : own + pressed;
  };
  for (double n = std::round(t / step); n > 0.0; --n) {
    const double rate_1 = section_4_3(v.v_1, sum(v.v_1, v.v_2, true), k, w, 2.0, 1.0);
    const double rate_2 = section_4_3(v.v_2, sum(v.v_2, v.v_1, false), k, w, 2.0, 1.0);
    v = {v.v_1 + step * rate_1, v.v_2 + step * rate_2};
  }
  return v;
}

// Figure 4.5: both plants share everything (all phi = 1, the plant itself included). Midpoint
// steps.
inline TwoPlants run_figure_4_5(TwoPlants v, double k, double w, double delta, double a, double t,
                                double step) {
  const auto rates = [&](const TwoPlants& u) {
    const double sum = u.v_1 + u.v_2;
    return TwoPlants{section_4_3(u.v_1, sum, k, w, delta, a),
                     section_4_3(u.v_2, sum, k, w, delta, a)};
  };
  for (double n = std::round(t / step); n > 0.0; --n) {
    const TwoPlants now = rates(v);
    const TwoPlants half = rates({v.v_1 + 0.5 * step * now.v_1, v.v_2 + 0.5 * step * now.v_2});
    v = {v.v_1 + step * half.v_1, v.v_2 + step * half.v_2};
  }
  return v;
}

// (4.7) as printed: the rate is that of the next step, so that the equation must be solved; by
// putting the result in again until it stays, which it does for steps that change little.
template <typename Rate>
double equation_4_7_as_printed(double v, const Rate& dv_dt) {
  double next = v;
  for (int i = 0; i < 10'000; ++i) next = v + dv_dt(next);
  return next;
}
template <typename Rate>
double equation_4_7_corrected(double v, const Rate& dv_dt) {
  return v + dv_dt(v);
}

// (4.8): history[l] is the size l steps ago. Printed with n + 1 terms.
inline double equation_4_8_as_printed(const std::vector<double>& history, std::size_t n) {
  double sum = 0.0;
  for (std::size_t l = 0; l <= n; ++l) sum += history[l];
  return sum / static_cast<double>(n);
}
inline double equation_4_8_corrected(const std::vector<double>& history, std::size_t n) {
  double sum = 0.0;
  for (std::size_t l = 0; l < n; ++l) sum += history[l];
  return sum / static_cast<double>(n);
}

// Section 4.5: a plant dies if its mean size stays below a threshold; meant is its mean growth.
inline bool dies_as_printed(const std::vector<double>& history, std::size_t n, double threshold) {
  return equation_4_8_as_printed(history, n) < threshold;
}
inline bool dies_corrected(const std::vector<double>& history, std::size_t n, double threshold) {
  return (history[0] - history[n]) / static_cast<double>(n) < threshold;
}

// (5.8), and the highest rate that it reaches, by trying sizes.
inline double equation_5_8(double MGR, double R_basal, double R_max) {
  return MGR * R_basal / R_max * (1.0 - R_basal / R_max);
}
inline double highest_rate_5_8(double MGR) {
  double highest = 0.0;
  for (int i = 0; i <= 1000; ++i) highest = std::fmax(highest, equation_5_8(MGR, i / 1000.0, 1.0));
  return highest;
}

}  // namespace phytobench::oracles::alsweis::growth
