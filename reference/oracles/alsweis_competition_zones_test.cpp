// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_competition_zones.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::competition {
namespace {

TEST(LiteralZoneIndexLaw, CountsRingsFromInside) {
  EXPECT_EQ(zone_index_F(5.5, 5, 1), 5);
  EXPECT_EQ(zone_index_F(4.5, 1, 5), 4);
  EXPECT_EQ(zone_index_F(3.5, 5, 1), 3);
  EXPECT_EQ(zone_index_F(3.0, 5, 1), 2);
  EXPECT_EQ(zone_index_F(2.0, 5, 1), 1);
  EXPECT_EQ(zone_index_F(0.0, 5, 1), 1);
  EXPECT_EQ(zone_index_F(100.0, 5, 1), 5);
}

// Figure 5.3: two equal crowns meet in ring 5, in 5 and 4, in 5, 4 and 3.
TEST(LiteralZoneIndexLaw, IsTheInnermostRingThatHoldsAPartOfTheOverlap) {
  CounterStream stream(3, 0);
  for (int i = 0; i < 2000; ++i) {
    const double larger = 1.0 + stream.next_unit(), smaller = larger * stream.next_unit();
    const double distance = stream.next_unit() * (larger + smaller);
    int innermost = 5;
    for (int F = 4; F >= 1; --F)
      if (overlap_in_ring(F, distance, smaller, larger) > 0.0) innermost = F;
    EXPECT_EQ(zone_index_F(distance, smaller, larger), innermost) << distance << " " << smaller;
  }
}

TEST(LiteralRingsLaw, HoldTheWholeOverlap) {
  CounterStream stream(4, 0);
  for (int i = 0; i < 1000; ++i) {
    const double smaller = 0.05 + stream.next_unit(), larger = smaller + stream.next_unit();
    const double distance = stream.next_unit() * (larger + smaller);
    double sum = 0.0;
    for (int F = 1; F <= 5; ++F) {
      const double part = overlap_in_ring(F, distance, smaller, larger);
      EXPECT_GE(part, -1e-12);
      sum += part;
    }
    EXPECT_NEAR(sum, equation_a4_corrected(smaller, larger, distance), 1e-12);
  }
}

TEST(LiteralLightLaw, IsWeightedByRing) {
  for (int F = 1; F <= 5; ++F)
    EXPECT_DOUBLE_EQ(equations_5_3_and_5_4(2, F, 4), std::min(1.0, 3.0 / F) * 0.5);
  EXPECT_EQ(equation_5_3(2, 3, 4), equation_5_4(2, 4));  // both forms meet in ring 3
}

TEST(LiteralLightLaw, JumpsFromRingToRingUnlessEveryPartIsWeighted) {
  const auto printed = [](double d) {
    return equations_5_3_and_5_4(equation_a4_corrected(1, 5, d), zone_index_F(d, 1, 5),
                                 disc_area_of(1));
  };
  EXPECT_NEAR(printed(4.0001), 0.749999, 1e-6);
  EXPECT_NEAR(printed(3.9999), 1.0, 1e-6);
  EXPECT_NEAR(printed(5 - 1e-9) / printed(5 + 1e-9), 1.25, 1e-6);
  EXPECT_NEAR(ringwise_5_3_and_5_4(4.0001, 1, 5), 0.671005, 1e-6);
  EXPECT_NEAR(ringwise_5_3_and_5_4(3.9999, 1, 5), 0.671024, 1e-6);
  for (double d = 0.1; d < 6; d += 0.1)
    EXPECT_NEAR(ringwise_5_3_and_5_4(d - 1e-9, 1, 5), ringwise_5_3_and_5_4(d + 1e-9, 1, 5), 1e-7);
}

TEST(LiteralLossLaw, OfTheSmallerIsAllAndOfBothTheOverlap) {
  EXPECT_EQ(equation_5_2(1, 2, 3) + equation_5_2(2, 1, 3), 3);
  EXPECT_EQ(equation_5_2(1, 2, 3), 3);
  EXPECT_EQ(equation_5_2(1, 1, 3) + equation_5_2(1, 1, 3), 3);
  EXPECT_NEAR(equation_5_1(equation_a4_corrected(1, 1, 1), disc_area_of(1)), 0.195501, 1e-6);
}

TEST(LiteralSignsLaw, SwitchTermsOffAndTurnThem) {
  EXPECT_EQ(equation_5_6(1, 1, 0.3, 0.7, 0.2), equation_5_5(0.3, 0.7, 0.2));
  EXPECT_EQ(equation_5_6(-1, -1, 0.3, 0.7, 0.2), -equation_5_5(0.3, 0.7, 0.2));
  EXPECT_EQ(equation_5_6(0, 1, 0.3, 0.7, 0.2), equation_5_5(0.3, 0.0, 0.2));
  std::set<std::string> cells;
  for (const int s1 : {-1, 0, 1})
    for (const int s2 : {-1, 0, 1}) cells.insert({table_5_1_letter(s2), table_5_1_letter(s1)});
  EXPECT_EQ(cells.size(), 9u);
}

TEST(LiteralFactorLaw, FallsToNothingAtHalfAndHasNoUpperLimit) {
  EXPECT_EQ(equation_5_7(0), 1.0);
  EXPECT_EQ(equation_5_7(0.25), 0.5);
  EXPECT_EQ(equation_5_7(0.5), 0.0);
  EXPECT_EQ(equation_5_7(0.7), 0.0);
  EXPECT_EQ(equation_5_7(-2), 5.0);
}

// (5.8) with steps ever shorter tends to the logistic curve, at first order.
TEST(LiteralGrowthLaw, ConvergesToTheLogisticCurve) {
  const double exact = 0.5 / (1 + 9 * std::exp(-0.1 * 60));
  double before = 0.0;
  for (const int parts : {50, 100, 200}) {
    double R = 0.05;
    for (int t = 0; t < 60 * parts; ++t) R += equation_5_9(equation_5_8(0.05, R, 0.5), 1) / parts;
    const double error = std::abs(R - exact);
    if (before > 0.0) EXPECT_NEAR(before / error, 2.0, 0.05);
    before = error;
  }
  EXPECT_NEAR(exact, 0.489089, 1e-6);
  EXPECT_EQ(equation_5_8(0.05, 0.5, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(equation_5_8(0.05, 0.25, 0.5), 0.0125);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::competition
