// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_competition_extended.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::competition {
namespace {

TEST(LiteralOpacityLaw, OnlyTheCorrectedFormSharesOutTheOverlap) {
  for (const double L : {0.0, 1.0, 2.5, 5.0}) {
    const double q = 5.0, gamma = 3.0;
    EXPECT_DOUBLE_EQ(
        equation_7_2_corrected(q, L, gamma, 1, 2) + equation_7_2_corrected(q, L, gamma, 2, 1),
        gamma);
    EXPECT_DOUBLE_EQ(2 * equation_7_2_as_printed(q, L, gamma), (1 + L / q) * gamma);
    EXPECT_EQ(equation_7_2_corrected(q, L, gamma, 2, 2), gamma / 2);
  }
}

TEST(LiteralOpacityLaw, GoesFromHalvesToAll) {
  EXPECT_EQ(equation_7_2_corrected(1, 0, 1, 1, 2), 0.5);
  EXPECT_EQ(equation_7_2_corrected(1, 0, 1, 2, 1), 0.5);
  EXPECT_EQ(equation_7_2_corrected(1, 1, 1, 1, 2), 1.0);
  EXPECT_EQ(equation_7_2_corrected(1, 1, 1, 2, 1), 0.0);
  EXPECT_EQ(equation_7_2_as_printed(1, 1, 1), 1.0);
}

TEST(LiteralRootsLaw, LieBetweenOneAndTwoTimesTheHealthyLoss) {
  CounterStream stream(2, 0);
  for (int i = 0; i < 1000; ++i) {
    const double gamma = stream.next_unit(), A = 1 + stream.next_unit(), m = 0.1 + 9 * i;
    const double sigma = equation_7_3(gamma, A, m * stream.next_unit(), m);
    EXPECT_GE(sigma, equation_5_1(gamma, A));
    EXPECT_LE(sigma, gamma / A * (1 + 1e-15));
  }
}

TEST(LiteralRootsLaw, DeepAgainstFlatIsHalfOfDeepAgainstDeep) {
  for (const double m : {1.0, 7.0}) {
    EXPECT_DOUBLE_EQ(equation_7_3(1, 3, T_f_corrected(0, m), m) * 2,
                     equation_7_3(1, 3, T_f_corrected(1, m), m));
    EXPECT_DOUBLE_EQ(equation_7_3(1, 3, T_f_as_printed(1, 0, m), m) * 2,
                     equation_7_3(1, 3, T_f_as_printed(1, 1, m), m));
  }
  EXPECT_EQ(T_f_as_printed(1, 0, 1), T_f_as_printed(0, 1, 1));  // neither can win
  EXPECT_NE(T_f_corrected(0, 1), T_f_corrected(1, 1));
}

TEST(LiteralIllnessLaw, FreesTheHealthyPlantOnlyWhenCorrected) {
  const double healthy = equation_5_1(2, 5);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_as_printed(3, 0, 40), 3), 3 * healthy);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_as_printed(3, 40, 40), 3), healthy);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_as_printed(3, 90, 40), 3), healthy);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_corrected(3, 0, 40), 3), healthy);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_corrected(3, 20, 40), 3), healthy / 2);
  EXPECT_DOUBLE_EQ(equation_7_4(2, 5, T_k_corrected(3, 90, 40), 3), 0);
}

TEST(LiteralNurseLaw, IsTheCellOfTableFiveOneWhoseRootsHelp) {
  EXPECT_EQ(equation_7_6_as_printed(0.3, 0.6, 0.4), equation_5_6(1, -1, 0.3, 0.6, 0.4));
  EXPECT_EQ(equation_7_6_as_told(0.3, 0.6, 0.4), equation_5_6(-1, 1, 0.3, 0.6, 0.4));
  EXPECT_EQ(equation_7_5(0.3, 0.6, 0.4), equation_5_5(0.3, 0.6, 0.4));
  EXPECT_EQ(nutrient_share_7_5_corrected(0.2), 0.8);
  EXPECT_EQ(nutrient_share_7_5_as_printed(0.2), 0.2);
}

TEST(LiteralRingsLaw, DivideTheConstantOfLight) {
  for (int F = 1; F <= 5; ++F) {
    EXPECT_DOUBLE_EQ(equation_7_1(3, 2, F, 4), 1.5 / F);
    if (F >= 3) EXPECT_DOUBLE_EQ(equation_7_1(3, 2, F, 4), equations_5_3_and_5_4(2, F, 4));
  }
  EXPECT_GT(equation_7_1(3, 2, 1, 4), equations_5_3_and_5_4(2, 1, 4));  // and not for F = 1, 2
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::competition
