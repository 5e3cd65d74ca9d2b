// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_growth.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/population/coupled_growth.hpp"
#include "core/population/density_laws.hpp"
#include "core/population/richards_growth.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::growth {
namespace {

/// Calls use(draw) a thousand times; draw(low, high) gives uniform numbers.
template <typename Use>
void for_random_points(std::uint64_t number, const Use& use) {
  CounterStream stream(17, number);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * stream.next_unit();
  };
  for (int i = 0; i < 1000; ++i) use(draw);
}

double rounding(double value) {
  return 1e-12 * std::fmax(1.0, std::abs(value));
}

TEST(RichardsGrowthOracle, AgreesWithTheSuite) {
  for_random_points(0, [](const auto& draw) {
    double delta = draw(-2, 5);
    if (std::abs(delta - 1.0) < 0.01) delta = 2.0;  // where the literal form loses digits
    const double k = draw(0.01, 1), w = draw(1, 100), v = w * draw(0.01, 2), t = draw(0, 50);
    const RichardsGrowth law{k, w, delta};
    const double rate = equation_2_1(v, k, w, delta), size = solution_of_2_1(v, k, w, delta, t);
    EXPECT_NEAR(richards_rate(law, v), rate, rounding(rate));
    EXPECT_NEAR(richards_size(law, v, t), size, rounding(size));
    const RichardsGrowth gompertz{k, w, 1.0};
    EXPECT_NEAR(richards_rate(gompertz, v), gompertz_rate(v, k, w), rounding(v));
    EXPECT_NEAR(richards_size(gompertz, v, t), gompertz_solution(v, k, w, t), rounding(w));
  });
}

TEST(DensityLawsOracle, AgreeWithTheSuite) {
  for_random_points(1, [](const auto& draw) {
    const double x = draw(0, 1000), m_d = draw(0, 0.1), m_i = draw(0, 1);
    EXPECT_NEAR(surviving_density(x, m_d), equation_2_2(x, m_d), rounding(x));
    EXPECT_NEAR(surviving_density(x, m_d, m_i), equation_2_3(x, m_d, m_i), rounding(x));
    EXPECT_EQ(linear_fecundity(x, m_i, m_d), equation_2_4(x, m_i, m_d));
    const double alpha = draw(0.1, 3), beta = draw(0, 2), phi = draw(0.2, 3), theta = draw(0.2, 3);
    const double seeds = equation_2_5(x, alpha, beta, phi, theta);
    EXPECT_NEAR(seeds_per_plant({alpha, beta, phi, theta}, x), seeds, rounding(seeds));
    const double D = draw(0.01, 100), b = draw(0.1, 100), k = draw(0.5, 3);
    const double weight = equation_2_15(D, b, k);
    EXPECT_NEAR(thinned_weight({b, k}, D), weight, rounding(weight));
    EXPECT_NEAR(std::log10(weight), equation_2_16(D, b, k), 1e-12);
    EXPECT_NEAR(thinning_constant(k, weight, D), equation_2_17(weight, D, k), 1e-12);
    EXPECT_NEAR(equation_2_17(weight, D, k), meaning_of_B_corrected(b), 1e-12);
  });
}

TEST(CoupledGrowthOracle, AgreesWithTheSuite) {
  for_random_points(2, [](const auto& draw) {
    const double k = draw(0.01, 0.2), w = draw(5, 20), a = draw(0, 2.5);
    const double delta = draw(0, 1) < 0.2 ? 1.0 : draw(1.1, 4);
    const std::vector<double> v{draw(0.1, 6), draw(0.1, 6), draw(0.1, 6)};
    const double s01 = draw(0, 1), s02 = draw(0, 1);
    const OverlapShares shares(3, {1, s01, s02, 0.5, 1, 0.5, 0, 0, 1});
    const auto rates = coupled_growth_rates({k, w, delta, a}, shares, v);
    const double sum = sum_4_3_corrected(v[0], {v[1], v[2]}, {s01, s02});
    const double first = section_4_3(v[0], sum, k, w, delta, a);
    const double last = section_4_3(v[2], v[2], k, w, delta, a);
    EXPECT_NEAR(rates[0], first, rounding(first));
    EXPECT_NEAR(rates[2], last, rounding(last));
  });
}

// The gain read as a loss: the smaller plant grows freely and catches up where e^(k t) = 1 + 10 ln
// 2, at t = 20.71; from then on both take turns at being the larger one, beyond w.
TEST(PrintedGrowthLawOracle, LetsTheSmallerPlantCatchUpAndBothOutgrowTheFinalSize) {
  const auto after = [](double t, double step) {
    return run_4_3({1, 2}, 0.1, 10, 1, t, step, true);
  };
  EXPECT_NEAR(after(20, 0.01).v_1, 7.38, 0.005);
  EXPECT_NEAR(after(20, 0.01).v_2, 7.80, 0.005);
  for (const double step : {0.01, 0.001}) {
    EXPECT_NEAR(after(30, step).v_1, 12.49, 0.002 * 12.49);
    EXPECT_NEAR(after(40, step).v_2, 16.38, 0.002 * 16.38);
    EXPECT_NEAR(after(60, step).v_1, 19.42, 0.002 * 19.42);
  }
  // Where they press each other in turns, v' = k v (1 - v / 20).
  const double v = after(30, 0.001).v_1, onwards = after(40, 0.001).v_1;
  EXPECT_NEAR(onwards, 20 / (1 + (20 / v - 1) * std::exp(-1.0)), 0.01);
}

TEST(CorrectedGrowthLawOracle, KeepsTheOrderAndTheFinalSize) {
  double last = 0.5;
  for (const double t : {10.0, 30.0, 100.0, 200.0}) {
    const TwoPlants v = run_4_3({1, 2}, 0.1, 10, 1, t, 0.01, false);
    EXPECT_LT(v.v_1 / v.v_2, last) << "the smaller one falls back";
    EXPECT_LT(v.v_2, 10.0);
    last = v.v_1 / v.v_2;
  }
  // Without asymmetric competition both are pressed alike.
  const TwoPlants even = run_4_3({1, 1}, 0.1, 10, 0, 400, 0.01, false);
  EXPECT_NEAR(even.v_1, even.v_2, 1e-12);
  EXPECT_NEAR(even.v_1, 10 / 1.5, 1e-6);
}

TEST(PrintedMeanOracle, CountsOneStepTooMany) {
  const std::vector<double> history{1, 1, 1, 1, 1, 1};
  EXPECT_NEAR(equation_4_8_as_printed(history, 5), 1.2, 1e-15);
  EXPECT_NEAR(equation_4_8_corrected(history, 5), 1.0, 1e-15);
}

TEST(PrintedMortalityOracle, KillsSeedlingsThatGrowWell) {
  // Newest first; growth of a tenth per step.
  const std::vector<double> seedling{0.0805, 0.0732, 0.0666, 0.0605, 0.055, 0.05}, stopped(6, 10.0);
  EXPECT_TRUE(dies_as_printed(seedling, 5, 0.5));
  EXPECT_FALSE(dies_as_printed(stopped, 5, 0.5));
  EXPECT_FALSE(dies_corrected(seedling, 5, 0.001));
  EXPECT_TRUE(dies_corrected(stopped, 5, 0.001));
}

TEST(PrintedStepOracle, SolvesAnEquation) {
  const auto rate = [](double v) { return 0.1 * v * (1 - v / 10); };
  const double next = equation_4_7_as_printed(1.0, rate);
  EXPECT_NEAR(next - rate(next), 1.0, 1e-15);
  EXPECT_NEAR(next, 1.097722, 5e-7);
  EXPECT_NEAR(equation_4_7_corrected(1.0, rate), 1.09, 1e-15);
}

TEST(RadiusGrowthOracle, ReachesAQuarterOfItsHighestRate) {
  EXPECT_NEAR(highest_rate_5_8(0.05), 0.0125, 1e-15);
  EXPECT_EQ(equation_5_8(0.05, 0.0, 0.5), 0.0);
  EXPECT_EQ(equation_5_8(0.05, 0.5, 0.5), 0.0);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::growth
