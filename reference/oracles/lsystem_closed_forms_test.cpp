// SPDX-License-Identifier: MIT
// The published and the collected numbers against the closed forms; lsystem_counts_test.cpp checks
// the closed forms against the matrices of the systems.
#include "reference/oracles/lsystem_closed_forms.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench::oracles {
namespace {

using Counts = std::vector<Count>;

Counts values(Count (*form)(int), int from, int to) {
  Counts all;
  for (int n = from; n <= to; ++n) all.push_back(form(n));
  return all;
}

TEST(LSystemClosedForms, OfLiebemannHaveTheirNumbers) {
  EXPECT_EQ(values(equation_2_1_cells, 0, 12),
            (Counts{1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233, 377}));
  EXPECT_EQ(values(equation_2_2_modules, 0, 5), (Counts{1, 2, 4, 7, 11, 16}));
  EXPECT_EQ(values(equation_2_6_F, 0, 4), (Counts{4, 32, 256, 2048, 16384}));
  EXPECT_EQ(values(equation_2_6_plus, 0, 3), (Counts{0, 12, 108, 876}));
  EXPECT_EQ(values(equation_2_6_minus, 0, 3), (Counts{3, 15, 111, 879}));
  EXPECT_EQ(values(equation_2_6_letters, 0, 3), (Counts{7, 59, 475, 3803}));
  for (int n = 0; n <= 3; ++n)
    EXPECT_EQ(equation_2_6_drawn_length(n),
              static_cast<double>(equation_2_6_F(n)) * 400 / static_cast<double>(1 << (2 * n)));
  EXPECT_EQ(figure_2_5a_F(4), 4096u);
  EXPECT_EQ(figure_2_5a_letters(4), 11116u);
  EXPECT_EQ(figure_2_5a_pairs(4), 1170u);
  EXPECT_EQ(figure_2_5a_plus(4), 2340u);
  EXPECT_EQ(figure_2_5b_F(5), 3125u);
  EXPECT_EQ(figure_2_5b_letters(5), 9373u);
  EXPECT_EQ(figure_2_5b_pairs(5), 2343u);
  EXPECT_EQ(figure_2_5b_plus(5), 781u);
}

TEST(LSystemClosedForms, OfEquation217HaveTheirNumbers) {
  EXPECT_EQ(equation_2_17_A(8), 6561u);
  EXPECT_EQ(equation_2_17_F(8), 13120u);
  EXPECT_EQ(equation_2_17_pairs(8), 9840u);
  EXPECT_EQ(equation_2_17_modules(8), 55762u);
  EXPECT_NEAR(equation_2_17_drawn_length(8, 1.3), 770922.66974, 5e-6);
  EXPECT_NEAR(equation_2_17_path_length(8, 1.3), 2385.76907, 5e-6);
  EXPECT_EQ(equation_2_17_depth(8), 16u);
  EXPECT_EQ(equation_2_17_nodes_of_degree_1(8), 3280u);
  EXPECT_EQ(equation_2_17_nodes_of_degree_3(8), 3280u);
  // Nodes: one more than edges.
  EXPECT_EQ(equation_2_17_A(8) + 2 * 3280, equation_2_17_F(8) + 1);
}

TEST(LSystemClosedForms, OfBrzoskaHaveTheirNumbers) {
  EXPECT_EQ(values(equation_5_F, 1, 6), (Counts{4, 16, 64, 256, 1024, 4096}));
  EXPECT_EQ(values(equation_5_letters, 1, 6), (Counts{8, 36, 148, 596, 2388, 9556}));
  EXPECT_EQ(values(equation_6_F, 1, 7), (Counts{9, 54, 252, 1080, 4464, 18144, 73152}));
  EXPECT_EQ(equation_6_X(7), 16384u);
  EXPECT_EQ(equation_6_pairs(7), 21844u);
  EXPECT_EQ(equation_6_plus(7), 27305u);
  EXPECT_EQ(equation_6_letters(7), 187834u);
}

TEST(LSystemClosedForms, OfTheBushHaveTheirNumbers) {
  using namespace lintermann1997;
  EXPECT_EQ(values(bush_F, 1, 7), (Counts{3, 12, 42, 135, 420, 1284, 3891}));
  EXPECT_EQ(values(bush_L, 1, 7), (Counts{3, 9, 30, 93, 285, 864, 2607}));
  EXPECT_EQ(values(bush_polygons, 1, 7), (Counts{0, 3, 12, 42, 135, 420, 1284}));
  EXPECT_EQ(bush_A(5), 243u);
  EXPECT_EQ(bush_S(5), 135u);
  EXPECT_EQ(bush_pairs(5), 498u);
  EXPECT_EQ(bush_groups(5), 363u);
  EXPECT_EQ(bush_primes(5, {}), 647u);
  EXPECT_EQ(bush_slashes(5, {}), 2412u);
  EXPECT_EQ(bush_letters(5, {}), 8294u);
  EXPECT_EQ(bush_slashes(5, {8, 8, 8, 3}), 3472u);
  EXPECT_EQ(bush_letters(5, {8, 8, 8, 3}), 9354u);
  EXPECT_EQ(bush_A(7), 2187u);
  EXPECT_EQ(bush_S(7), 1284u);
  EXPECT_EQ(bush_pairs(7), 4563u);
  EXPECT_EQ(bush_groups(7), 3279u);
  EXPECT_EQ(bush_primes(7, {}), 6038u);
  EXPECT_EQ(bush_slashes(7, {}), 22596u);
  EXPECT_EQ(bush_letters(7, {}), 77399u);
  EXPECT_EQ(bush_letters(7, {5, 7, 5, 2}), 76115u);
}

TEST(LSystemClosedFormsLaw, TheBushFollowsItsRecurrences) {
  using namespace lintermann1997;
  for (int n = 0; n < 20; ++n) {
    EXPECT_EQ(bush_A(n + 1), 3 * bush_A(n));
    EXPECT_EQ(bush_F(n + 1), bush_F(n) + bush_S(n) + 3 * bush_A(n));
    EXPECT_EQ(bush_S(n + 1), bush_F(n));
    EXPECT_EQ(bush_L(n + 1), bush_S(n) + 3 * bush_A(n));
    EXPECT_EQ(bush_polygons(n + 1), bush_polygons(n) + bush_L(n));
    EXPECT_EQ(bush_F_replaced(n + 1), bush_F_replaced(n) + bush_F(n));
  }
  EXPECT_NEAR(static_cast<double>(bush_F(20)) / static_cast<double>(bush_A(20)), 1.8, 1e-4);
}

}  // namespace
}  // namespace phytobench::oracles
