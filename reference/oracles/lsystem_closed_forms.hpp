// SPDX-License-Identifier: MIT
// Closed forms of the L-systems of [Liebemann2017], [Lintermann1997] and [Brzoska2019] after n
// steps, derived from their productions by hand; for n >= 0 as long as 64 bits hold the value.
// "pairs" are pairs of brackets. Shares no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

namespace phytobench::oracles {

using Count = std::uint64_t;

inline Count whole_power(Count base, int exponent) {
  Count power = 1;
  for (int i = 0; i < exponent; ++i) power *= base;
  return power;
}

// 1 + base + ... + base^(n - 1): how often a letter has been replaced that becomes `base` of its
// kind in each step.
inline Count replacements(Count base, int n) {
  return (whole_power(base, n) - 1) / (base - 1);
}

inline Count fibonacci(int n) {
  Count before = 1, now = 0;  // F(-1), F(0)
  for (int i = 0; i < n; ++i) {
    const Count next = before + now;
    before = now;
    now = next;
  }
  return now;
}

// [Liebemann2017] eq. 2.1: every step is one of Fibonacci's; big cells are a_l and a_r.
inline Count equation_2_1_cells(int n) {
  return fibonacci(n + 2);
}
inline Count equation_2_1_big_cells(int n) {
  return fibonacci(n + 1);
}

// Eq. 2.2: one A, a new B in each step, and a C behind every B in each later step.
inline Count equation_2_2_C(int n) {
  const auto steps = static_cast<Count>(n);
  return steps < 2 ? 0 : steps * (steps - 1) / 2;
}
inline Count equation_2_2_modules(int n) {
  return 1 + static_cast<Count>(n) + equation_2_2_C(n);
}
inline std::string equation_2_2_word(int n) {
  std::string word = "A(" + std::to_string(n + 1) + "," + std::to_string(whole_power(2, n)) + ")";
  for (int born = n; born >= 1; --born) {
    const Count age = static_cast<Count>(n - born);
    word += "B(" + std::to_string(whole_power(2, born - 1) + age) + ")" + std::string(age, 'C');
  }
  return word;
}

// Eq. 2.6, the island: F becomes 8 F, 3 + and 3 -.
inline Count equation_2_6_F(int n) {
  return 4 * whole_power(8, n);
}
inline Count equation_2_6_plus(int n) {
  return 4 * 3 * replacements(8, n);
}
inline Count equation_2_6_minus(int n) {
  return 3 + equation_2_6_plus(n);
}
inline Count equation_2_6_letters(int n) {
  return equation_2_6_F(n) + equation_2_6_plus(n) + equation_2_6_minus(n);
}
inline double equation_2_6_drawn_length(int n) {  // with steps of 400 / 4^n, as figure 2.4 has them
  return 1600.0 * static_cast<double>(whole_power(2, n));
}
inline Count equation_2_6_overhang(int n) {  // over the square, in steps; its side has 4^n
  return replacements(4, n);
}

// Figure 2.5a: F becomes 8 F, 4 +, 4 - and 2 pairs.
inline Count figure_2_5a_F(int n) {
  return whole_power(8, n);
}
inline Count figure_2_5a_plus(int n) {  // and as many -
  return 4 * replacements(8, n);
}
inline Count figure_2_5a_pairs(int n) {
  return 2 * replacements(8, n);
}
inline Count figure_2_5a_letters(int n) {
  return figure_2_5a_F(n) + 2 * figure_2_5a_plus(n) + 2 * figure_2_5a_pairs(n);
}

// Figure 2.5b: F becomes 5 F, one +, one - and 3 pairs.
inline Count figure_2_5b_F(int n) {
  return whole_power(5, n);
}
inline Count figure_2_5b_plus(int n) {  // and as many -
  return replacements(5, n);
}
inline Count figure_2_5b_pairs(int n) {
  return 3 * replacements(5, n);
}
inline Count figure_2_5b_letters(int n) {
  return figure_2_5b_F(n) + 2 * figure_2_5b_plus(n) + 2 * figure_2_5b_pairs(n);
}

// Eq. 2.17: A becomes 3 A, 4 F, 3 pairs with an & each, and 2 /; the axiom has one / more.
inline Count equation_2_17_A(int n) {  // and as many /: 1 + 2 (3^n - 1) / 2
  return whole_power(3, n);
}
inline Count equation_2_17_F(int n) {
  return 4 * replacements(3, n);
}
inline Count equation_2_17_pairs(int n) {  // and as many &
  return 3 * replacements(3, n);
}
inline Count equation_2_17_modules(int n) {
  return 2 * equation_2_17_A(n) + equation_2_17_F(n) + 3 * equation_2_17_pairs(n);
}
// Step k adds 4 F of length 50 for each of 3^(k-1) A; each later step makes them l_r times longer.
inline double equation_2_17_drawn_length(int n, double l_r) {
  double length = 0;
  for (int k = 1; k <= n; ++k)
    length += 4.0 * static_cast<double>(whole_power(3, k - 1)) * 50.0 * std::pow(l_r, n - k);
  return length;
}
// From the root to any tip: two of them of each step. l_r is not 1.
inline double equation_2_17_path_length(int n, double l_r) {
  return 100.0 * (std::pow(l_r, n) - 1.0) / (l_r - 1.0);
}
inline Count equation_2_17_depth(int n) {
  return 2 * static_cast<Count>(n);
}
// Nodes with 1 and nodes with 3 successors: where an A stood when it was replaced, and behind the F
// that it then became.
inline Count equation_2_17_nodes_of_degree_1(int n) {
  return replacements(3, n);
}
inline Count equation_2_17_nodes_of_degree_3(int n) {
  return replacements(3, n);
}

// [Brzoska2019] eq. 5: F becomes 4 F, two + and two -. The curve ends 3^n steps from its start.
inline Count equation_5_F(int n) {
  return whole_power(4, n);
}
inline Count equation_5_letters(int n) {
  return equation_5_F(n) + 4 * replacements(4, n);
}
inline Count equation_5_end(int n) {
  return whole_power(3, n);
}

// [Brzoska2019] eq. 6: X becomes 4 X, 9 F, 5 +, 5 - and 4 pairs; F becomes 2 F.
inline Count equation_6_X(int n) {
  return whole_power(4, n);
}
inline Count equation_6_F(int n) {
  return 9 * (whole_power(4, n) - whole_power(2, n)) / 2;
}
inline Count equation_6_plus(int n) {  // and as many -
  return 5 * replacements(4, n);
}
inline Count equation_6_pairs(int n) {
  return 4 * replacements(4, n);
}
inline Count equation_6_letters(int n) {
  return equation_6_X(n) + equation_6_F(n) + 2 * equation_6_plus(n) + 2 * equation_6_pairs(n);
}

}  // namespace phytobench::oracles
