// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_competition_shares.hpp"

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::competition {
namespace {

TEST(LiteralZoneLaw, GrowsWithThePowerOfTheStem) {
  EXPECT_NEAR(equation_4_1(10, 0.1, 0.5), 3.162278, 1e-6);
  EXPECT_DOUBLE_EQ(equation_4_1(15, 0.1, 1), 1.5);
  EXPECT_EQ(equation_4_1(1, 0.1, 0), 1.0);
  for (const double b : {0.0, 0.25, 0.5, 1.0})
    EXPECT_NEAR(equation_4_1(7, 0.4, b) / equation_4_1(7, 0.2, b), std::exp2(b), 1e-14);
}

TEST(LiteralSharesLaw, WhatOneWinsTheOtherLoses) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const double f_i = stream.next_unit(), f_j = stream.next_unit(), gamma = stream.next_unit();
    EXPECT_EQ(equation_4_3_as_printed(f_i, f_j, gamma) + equation_4_3_as_printed(f_j, f_i, gamma),
              gamma);
    EXPECT_EQ(equation_4_3_corrected(f_i, f_j, gamma), equation_4_3_as_printed(f_j, f_i, gamma));
    EXPECT_EQ(equation_4_2(gamma) + equation_4_2(gamma), gamma);
  }
}

TEST(LiteralSharesLaw, OfEqualsMustBeDecidedOncePerPair) {
  EXPECT_EQ(equation_4_3_as_printed(1, 1, 3) + equation_4_3_as_printed(1, 1, 3), 3);
  EXPECT_EQ(equation_4_3_as_printed(1, 1, 3, 1) + equation_4_3_as_printed(1, 1, 3, 0), 3);
  EXPECT_EQ(equation_4_3_as_printed(1, 1, 3, 1) + equation_4_3_as_printed(1, 1, 3, 1), 6);
  EXPECT_EQ(equation_4_3_as_printed(1, 1, 3, 0) + equation_4_3_as_printed(1, 1, 3, 0), 0);
}

TEST(LiteralSharesLaw, MixturesShareOutTheOverlap) {
  for (int i = 0; i <= 20; ++i) {
    const double p = i / 20.0;
    const double large = equation_4_4(p, equation_4_3_as_printed(2, 1, 1), equation_4_2(1));
    const double small = equation_4_4(p, equation_4_3_as_printed(1, 2, 1), equation_4_2(1));
    EXPECT_DOUBLE_EQ(large + small, 1.0);
    EXPECT_DOUBLE_EQ(large, p + (1 - p) / 2);
    EXPECT_DOUBLE_EQ(small, (1 - p) / 2);
  }
}

TEST(PrintedSharesOracle, SentencesSayTheOppositeOfTheFormula) {
  EXPECT_EQ(sentence_4_4_as_printed(0.25), 0.75);
  EXPECT_EQ(sentence_4_4_corrected(0.25), equation_4_4(0.25, 1, 0));
  EXPECT_EQ(balance_4_4_as_printed(0.5), 0.0);
  EXPECT_EQ(balance_4_4_corrected(0.5), 0.25);
  EXPECT_NEAR(balance_4_4_corrected(1.0 / 3.0), 0.0, 1e-15);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::competition
