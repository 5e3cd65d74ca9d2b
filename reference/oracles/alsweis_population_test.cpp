// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_population.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/population/cell_population.hpp"
#include "core/population/seed_bank.hpp"
#include "core/population/seed_dispersal.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::population {
namespace {

TEST(LogisticMapOracle, PrintedFormsAgreeButForOne) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const double r = stream.next_between(0.0, 4.0), K = stream.next_between(1.0, 1000.0);
    const double N = K * stream.next_unit();
    const double expected = equation_2_9(r, K, N);
    EXPECT_NEAR(equation_2_10_corrected(r, K, N), expected, 1e-12 * K);
    EXPECT_NEAR(equation_2_11(r - 1.0, -r / K, N), expected, 1e-12 * K);
    EXPECT_NEAR(LogisticMap::of_rate(r, K).next(N), expected, 1e-12 * K);
    EXPECT_NEAR(equation_2_10_as_printed(r, K, N) - expected, 2.0 * (1.0 - r) * N, 1e-12 * K);
  }
  EXPECT_NEAR(equation_2_10_as_printed(1.2, 100.0, 10.0), 6.8, 1e-12);
  EXPECT_NEAR(equation_2_10_corrected(1.2, 100.0, 10.0), 10.8, 1e-12);
}

TEST(LogisticMapOracle, TwoOrbitsMovingApartAreChaos) {
  for (const double alpha : {0.1, 0.3, 1.0, 1.9, 2.2, 2.5, 2.55, 2.7, 2.8, 3.0}) {
    const LogisticMap map = LogisticMap::of_rate(1.0 + alpha, 1.0);
    EXPECT_EQ(is_chaotic(alpha), lyapunov_exponent(map) > 0.0) << alpha;
    EXPECT_EQ(is_chaotic(alpha), alpha > fertility_of_chaos) << alpha;
  }
  EXPECT_FALSE(is_chaotic(2.835));  // three counts, in a window of the chaos
}

/// The same random counts in both, on a torus.
class CellsOracle : public testing::Test {
 protected:
  static constexpr std::size_t width = 9, height = 6;
  static constexpr double alpha = 0.6, capacity = 3.0, beta = -(1.0 + alpha) / capacity;

  void expect_equal_years(CellStep step, double gamma) const {
    CellPopulation ours({width, height}, {gamma, step, CellBorder::torus},
                        LogisticMap::of_rate(1.0 + alpha, capacity));
    CellCounts literal(width, std::vector<double>(height));
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t y = 0; y < height; ++y)
        ours.counts()[y * width + x] = literal[x][y] = random_unit(2, x, y);
    for (int t = 0; t < 20; ++t) {
      ours.step();
      literal = next(literal, step, gamma);
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t y = 0; y < height; ++y)
          ASSERT_NEAR(ours.count_at(x, y), literal[x][y], 1e-12) << "year " << t;
    }
  }

 private:
  static CellCounts next(const CellCounts& N, CellStep step, double gamma) {
    if (step == CellStep::positive_part) return equation_2_14(N, alpha, beta, gamma);
    if (step == CellStep::conserving) return grown_then_migrated(N, alpha, beta, gamma);
    CellCounts all = N;
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t y = 0; y < height; ++y)
        all[x][y] = equation_2_13(N, x, y, alpha, beta, gamma);
    return all;
  }
};

TEST_F(CellsOracle, CellPopulationsFollowThePrintedEquations) {
  expect_equal_years(CellStep::unclipped, 0.1);
  expect_equal_years(CellStep::positive_part, 0.1);
  expect_equal_years(CellStep::positive_part, 0.24);
}

TEST_F(CellsOracle, TheConservingStepIsGrowthThenLimitedMigration) {
  for (const double gamma : {0.05, 0.25, 0.6}) expect_equal_years(CellStep::conserving, gamma);
}

TEST_F(CellsOracle, ACheckerboardGrowsAsPrintedAndStaysBoundedAsCorrected) {
  const auto printed = [](const CellCounts& N) { return equation_2_14(N, 0.3, -1.3, 0.3); };
  const auto corrected = [](const CellCounts& N) { return grown_then_migrated(N, 0.3, -1.3, 0.3); };
  EXPECT_NEAR(largest_of_checkerboard(0.1, 10, printed), 0.619174, 1e-6);
  EXPECT_NEAR(largest_of_checkerboard(0.1, 100, printed) / 8.281797e6, 1.0, 1e-6);
  EXPECT_LE(largest_of_checkerboard(0.1, 100, corrected), 0.3 / 1.3 + 1e-12);
}

TEST(SeedBankOracle, YearsAreThoseOfThePrintedMaps) {
  CounterStream stream(3, 0);
  for (int run = 0; run < 100; ++run) {
    const SeedBankLetters a{.pi = stream.next_unit(),
                            .gamma = stream.next_unit(),
                            .sigma = stream.next_unit(),
                            .b_B = 20.0 * stream.next_unit(),
                            .b_N = 20.0 * stream.next_unit(),
                            .p = stream.next_unit(),
                            .v = 0.1 * stream.next_unit()};
    const SeedBankParameters ours{a.pi, a.gamma, a.sigma, a.b_B, a.b_N, a.p, a.v};
    SeedBank literal{10.0, 10.0, 10.0};
    SeedBankState state{10.0, 10.0, 10.0};
    for (int t = 0; t < 50; ++t) {
      ASSERT_NEAR(seedling_survival(ours, state, a.p), equation_4_9(literal, a), 1e-12);
      literal = section_4_6(literal, a);
      state = next_year(ours, state);
      ASSERT_NEAR(state.bankers, literal.B, 1e-9);
      ASSERT_NEAR(state.non_bankers, literal.N, 1e-9);
      ASSERT_NEAR(state.resting, literal.S, 1e-9);
    }
  }
}

TEST(DispersalOracle, TheDensityIsLambdaTimesTooLargeAsPrinted) {
  const SeedDispersal dispersal{.scale = 5.0};
  for (const double r : {0.1, 1.0, 20.0}) {
    EXPECT_NEAR(equation_4_6_corrected(r, 5.0), dispersal.distance_density(r), 1e-15);
    EXPECT_NEAR(equation_4_6_as_printed(r, 5.0), 5.0 * dispersal.distance_density(r), 1e-15);
  }
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::population
