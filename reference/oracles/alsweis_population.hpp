// SPDX-License-Identifier: MIT
// (2.9) to (2.14), (4.6), (4.9) and the three maps of section 4.6 of [Alsweis], literally. Shares
// no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace phytobench::oracles::alsweis::population {

// (2.9).
inline double equation_2_9(double r, double K, double N) {
  return r * N * (1.0 - N / K);
}

// (2.10), said to be (2.9) written out; it is for (r - 1) in the place of (1 - r).
inline double equation_2_10_as_printed(double r, double K, double N) {
  return N + (1.0 - r) * N + (-r / K) * N * N;
}
inline double equation_2_10_corrected(double r, double K, double N) {
  return N + (r - 1.0) * N + (-r / K) * N * N;
}

// (2.11).
inline double equation_2_11(double alpha, double beta, double N) {
  return N + alpha * N + beta * N * N;
}

// Whether (2.11) is chaotic: two counts that differ by a billionth move apart, on average over
// years in which they are brought back to that distance. K = 1.
inline bool is_chaotic(double alpha) {
  const double beta = -(1.0 + alpha), small = 1e-9;
  double N = 0.31, sum = 0.0;
  for (int t = 0; t < 10'000; ++t) N = equation_2_11(alpha, beta, N);
  for (int t = 0; t < 10'000; ++t) {
    const double next = equation_2_11(alpha, beta, N);
    const double apart = std::fabs(equation_2_11(alpha, beta, N + small) - next);
    sum += std::log(std::fmax(apart, 1e-30) / small);
    N = next;
  }
  return sum > 0.0;
}

// N[x][y], on a torus.
using CellCounts = std::vector<std::vector<double>>;

// (2.12).
inline double equation_2_12(const CellCounts& N, std::size_t x, std::size_t y) {
  const std::size_t w = N.size(), h = N[0].size();
  return N[x][(y + h - 1) % h] + N[x][(y + 1) % h] + N[(x + 1) % w][y] + N[(x + w - 1) % w][y] -
         4.0 * N[x][y];
}

// (2.13), one cell.
inline double equation_2_13(const CellCounts& N, std::size_t x, std::size_t y, double alpha,
                            double beta, double gamma) {
  return N[x][y] + alpha * N[x][y] + beta * N[x][y] * N[x][y] + gamma * equation_2_12(N, x, y);
}

// H of (2.14): as printed, and what the name "Heaviside operator" stands for.
inline double positive_part(double z) {
  return z > 0.0 ? z : 0.0;
}
inline double heaviside_step(double z) {
  return z > 0.0 ? 1.0 : 0.0;
}

// (2.14), all cells.
inline CellCounts equation_2_14(const CellCounts& N, double alpha, double beta, double gamma) {
  CellCounts next = N;
  for (std::size_t x = 0; x < N.size(); ++x)
    for (std::size_t y = 0; y < N[x].size(); ++y)
      next[x][y] = positive_part(equation_2_13(N, x, y, alpha, beta, gamma));
  return next;
}

// What takes its place: cells grow first, then at most all plants of a cell leave it.
inline CellCounts grown_then_migrated(const CellCounts& N, double alpha, double beta,
                                      double gamma) {
  CellCounts grown = N, next = N;
  for (std::size_t x = 0; x < N.size(); ++x)
    for (std::size_t y = 0; y < N[x].size(); ++y)
      grown[x][y] = positive_part(equation_2_11(alpha, beta, N[x][y]));
  for (std::size_t x = 0; x < N.size(); ++x)
    for (std::size_t y = 0; y < N[x].size(); ++y)
      next[x][y] = grown[x][y] + std::fmin(gamma, 0.25) * equation_2_12(grown, x, y);
  return next;
}

// A checkerboard of 0 and `size` on a torus of 4 x 4 cells, and its largest count after some years.
template <class Step>
double largest_of_checkerboard(double size, int years, const Step& step) {
  CellCounts N(4, std::vector<double>(4, 0.0));
  for (std::size_t x = 0; x < 4; ++x)
    for (std::size_t y = 0; y < 4; ++y) N[x][y] = (x + y) % 2 == 0 ? 0.0 : size;
  for (int t = 0; t < years; ++t) N = step(N);
  double largest = 0.0;
  for (const auto& column : N)
    for (const double count : column) largest = std::fmax(largest, count);
  return largest;
}

// (4.6): as printed, and as a density of distances whose mean is lambda.
inline double equation_4_6_as_printed(double r, double lambda) {
  return std::exp(-r / lambda);
}
inline double equation_4_6_corrected(double r, double lambda) {
  return std::exp(-r / lambda) / lambda;
}

// Section 4.6: densities of bankers, non-bankers and resting seeds, and parameters.
struct SeedBank {
  double B = 0.0, N = 0.0, S = 0.0;
};
struct SeedBankLetters {
  double pi, gamma, sigma, b_B, b_N, p, v;
};

// (4.9).
inline double equation_4_9(const SeedBank& t, const SeedBankLetters& a) {
  return a.p * std::exp(-a.v * (1.0 - a.pi) *
                        (a.b_N * t.N + (1.0 - a.sigma) * a.b_B * t.B + a.gamma * t.S));
}

// The three maps.
inline SeedBank section_4_6(const SeedBank& t, const SeedBankLetters& a) {
  const double P = equation_4_9(t, a);
  return {P * ((1.0 - a.sigma) * (1.0 - a.pi) * a.b_B * t.B + a.gamma * (1.0 - a.pi) * t.S),
          P * (1.0 - a.pi) * a.b_N * t.N,
          (1.0 - a.pi) * (1.0 - a.gamma) * t.S + (1.0 - a.pi) * a.sigma * a.b_B * t.B};
}

}  // namespace phytobench::oracles::alsweis::population
