// SPDX-License-Identifier: MIT
#include "core/population/logistic_map.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double rounding = 1e-12;

LogisticMap map_of(double fertility, double capacity = 100.0) {
  return LogisticMap::of_rate(1.0 + fertility, capacity);
}

TEST(LogisticMap, IsTheOneOfRateAndCapacity) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const double rate = stream.next_between(0.0, 4.0), capacity = stream.next_between(1.0, 1000.0);
    const LogisticMap map = LogisticMap::of_rate(rate, capacity);
    const double count = capacity * stream.next_unit();
    EXPECT_NEAR(map.next(count), rate * count * (1.0 - count / capacity), rounding * capacity);
    EXPECT_NEAR(map.reproduction_rate(), rate, rounding);
    EXPECT_NEAR(map.capacity() / capacity, 1.0, 1e-9);
  }
  EXPECT_TRUE(std::isinf(LogisticMap{}.capacity()));
  EXPECT_GT(LogisticMap{}.capacity(), 0.0);
  EXPECT_THROW(LogisticMap::of_rate(-0.1, 100.0), ContractViolation);
  EXPECT_THROW(LogisticMap::of_rate(2.0, 0.0), ContractViolation);
}

TEST(LogisticMap, TwoCountsAsFarFromHalfTheCapacityHaveTheSameFuture) {
  const LogisticMap map = map_of(1.7);
  for (const double off : {0.0, 1.0, 10.0, 49.0, 60.0})
    EXPECT_NEAR(map.next(50.0 - off), map.next(50.0 + off), rounding * 100.0);
  EXPECT_NEAR(map.next(map.capacity()), 0.0, rounding * 100.0);
  EXPECT_NEAR(map.next(50.0), map.largest_next(), rounding * 100.0);
  EXPECT_EQ(map.next(0.0), 0.0);
  EXPECT_LT(map.next(101.0), 0.0);
}

TEST(LogisticMap, MultiplierIsTheDerivative) {
  const LogisticMap map = map_of(0.8);
  constexpr double h = 1e-4;
  for (const double count : {0.0, 20.0, 50.0, 80.0})
    EXPECT_NEAR(map.multiplier(count), (map.next(count + h) - map.next(count - h)) / (2.0 * h),
                1e-8);
  EXPECT_NEAR(map.multiplier(map.equilibrium()), map.equilibrium_multiplier(), rounding);
}

TEST(LogisticMap, EquilibriumStaysForTenThousandYears) {
  for (const double fertility : {0.2, 0.3, 1.0, 1.5, 1.9}) {
    const LogisticMap map = map_of(fertility);
    EXPECT_NEAR(map.equilibrium(), 100.0 * (1.0 - 1.0 / (1.0 + fertility)), rounding * 100.0);
    for (const double count : orbit(map, map.equilibrium(), 10'000))
      ASSERT_NEAR(count, map.equilibrium(), 1e-12) << "fertility " << fertility;
  }
}

// The distance from the equilibrium is multiplied by 1 - alpha each year.
TEST(LogisticMap, NearsTheEquilibriumByTheMultiplier) {
  for (const double fertility : {0.2, 0.7, 1.3, 1.8}) {
    const LogisticMap map = map_of(fertility, 1.0);
    for (const double off : {1e-4, 1e-5}) {
      const double ratio = (map.next(map.equilibrium() + off) - map.equilibrium()) / off;
      EXPECT_NEAR(ratio, map.equilibrium_multiplier(), 3.0 * off);  // |beta| = 1 + alpha < 3
    }
  }
}

TEST(LogisticMap, DiesOutWithoutGrowth) {
  for (const double fertility : {-0.5, -0.1, 0.0}) {
    const std::vector<double> counts = orbit(map_of(fertility), 50.0, 100'000);
    for (std::size_t t = 1; t < counts.size(); ++t) ASSERT_LE(counts[t], counts[t - 1]);
    EXPECT_LT(counts.back(), 2e-3);  // at 0 only as K / t
  }
}

TEST(LogisticMapLaw, OrbitsKeepWithinTheCapacityUpToFertilityThree) {
  CounterStream stream(2, 0);
  for (int i = 0; i < 100; ++i) {
    const LogisticMap map = map_of(stream.next_between(-1.0, largest_bounded_fertility));
    for (const double count : orbit(map, 100.0 * stream.next_unit(), 1000)) {
      ASSERT_GE(count, -1e-9);
      ASSERT_LE(count, 100.0 + 1e-9);
    }
  }
  EXPECT_LT(orbit(map_of(3.05), 30.0, 1000).back(), -1e9);
}

// Multipliers of the cycles in closed form: 1 - alpha, and 5 - alpha^2 for two years.
TEST(LyapunovExponentLaw, IsThatOfTheCycle) {
  for (const double fertility : {0.1, 0.3, 0.9, 1.5, 1.9})
    EXPECT_NEAR(lyapunov_exponent(map_of(fertility)), std::log(std::abs(1.0 - fertility)), 1e-9);
  for (const double fertility : {2.1, 2.2, 2.3, 2.4})
    EXPECT_NEAR(lyapunov_exponent(map_of(fertility)),
                0.5 * std::log(std::abs(5.0 - fertility * fertility)), 1e-9);
  // At alpha = 3 the map is conjugate to doubling an angle. Squares of logarithms have a finite
  // mean, about 0.9^2 each: five standard errors.
  EXPECT_NEAR(lyapunov_exponent(map_of(3.0)), std::numbers::ln2, 5.0 * 0.9 / 256.0);
  const double at_middle = lyapunov_exponent(map_of(1.0));
  EXPECT_TRUE(std::isinf(at_middle) && at_middle < 0.0);
}

TEST(LyapunovExponentLaw, DoesNotDependOnTheUnitOfCounting) {
  for (const double fertility : {0.3, 2.2, 2.5})
    EXPECT_NEAR(lyapunov_exponent(map_of(fertility, 1.0)),
                lyapunov_exponent(map_of(fertility, 1e6)), 1e-9);
}

TEST(AttractorPeriod, DoublesAtTheThresholds) {
  const auto period = [](double fertility) { return attractor_period(map_of(fertility)); };
  for (const double fertility : {0.3, 1.0, 1.9, fertility_of_two_counts - 0.01})
    EXPECT_EQ(period(fertility), 1u) << fertility;
  for (const double fertility : {fertility_of_two_counts + 0.01, 2.2, 2.44})
    EXPECT_EQ(period(fertility), 2u) << fertility;
  for (const double fertility : {fertility_of_four_counts + 0.002, 2.5, 2.54})
    EXPECT_EQ(period(fertility), 4u) << fertility;
  EXPECT_EQ(period(2.55), 8u);
  EXPECT_EQ(period(fertility_of_chaos + 1e-4), std::nullopt);
  EXPECT_EQ(period(2.8), std::nullopt);
  EXPECT_EQ(period(fertility_of_three_counts + 0.002), 3u);  // a window in the chaos
  EXPECT_EQ(period(fertility_of_three_counts - 0.01), std::nullopt);
  EXPECT_EQ(attractor_period(map_of(2.55), 4), std::nullopt) << "longer than was asked for";
}

TEST(AttractorPeriod, TwoCountsAreThoseOfTheClosedForm) {
  const double a = 2.2, root = std::sqrt((a - 2.0) * (a + 2.0));
  const std::vector<double> counts = orbit(map_of(a, 1.0), 0.3, 10'001);
  const double one = counts[10'000], other = counts[10'001];
  EXPECT_NEAR(std::min(one, other), (a + 2.0 - root) / (2.0 * (1.0 + a)), rounding);
  EXPECT_NEAR(std::max(one, other), (a + 2.0 + root) / (2.0 * (1.0 + a)), rounding);
}

// Why the default start is no round number: from 0.3 the count is at the equilibrium at once.
TEST(AttractorPeriod, SomeStartsLeadToTheUnstableEquilibrium) {
  const LogisticMap map = map_of(7.0 / 3.0);
  EXPECT_EQ(attractor_period(map), 2u);
  EXPECT_EQ(attractor_period(map, 64, {.start = 0.3, .transient = 10}), 1u);
}

// An orbit that begins on a repelling cycle returns at first: rounding takes it away.
TEST(AttractorPeriod, OneReturnIsNoPeriod) {
  const double a = 2.8, root = std::sqrt((a - 2.0) * (a + 2.0));
  const double on_cycle = (a + 2.0 - root) / (2.0 * (1.0 + a));
  const LogisticMap map = map_of(a, 1.0);
  EXPECT_NEAR(map.next(map.next(on_cycle)), on_cycle, 1e-14);
  EXPECT_EQ(attractor_period(map, 64, {.start = on_cycle, .transient = 0}), std::nullopt);
}

TEST(SuperstableFertility, HasItsPeriodAndMultiplierZero) {
  EXPECT_EQ(superstable_fertility(0), 1.0);
  EXPECT_NEAR(superstable_fertility(1), std::sqrt(5.0), rounding);
  for (const std::size_t doublings : {1u, 2u, 3u, 4u, 5u}) {
    const LogisticMap map = map_of(superstable_fertility(doublings), 1.0);
    EXPECT_EQ(attractor_period(map), std::size_t{1} << doublings);
    double product = 1.0;
    for (const double count : orbit(map, 0.5, (std::size_t{1} << doublings) - 1))
      product *= map.multiplier(count);
    EXPECT_NEAR(product, 0.0, 1e-6);
  }
  EXPECT_THROW(superstable_fertility(13), ContractViolation);
}

TEST(SuperstableFertilityLaw, EndsWhereChaosBegins) {
  const double a = superstable_fertility(8), b = superstable_fertility(9),
               c = superstable_fertility(10);
  EXPECT_NEAR((b - a) / (c - b), 4.669201609, 1e-3);
  EXPECT_NEAR(c + (c - b) * (c - b) / ((b - a) - (c - b)), fertility_of_chaos, 1e-9);
}

TEST(LogisticMap, RefusesOrbitsWithoutBound) {
  EXPECT_THROW(lyapunov_exponent(map_of(3.1)), ContractViolation);
  EXPECT_THROW(lyapunov_exponent({.fertility = 1.0, .mortality = 0.0}), ContractViolation);
  EXPECT_THROW(attractor_period(map_of(0.0)), ContractViolation);
  EXPECT_THROW(attractor_period(map_of(1.0), 0), ContractViolation);
  EXPECT_THROW(lyapunov_exponent(map_of(1.0), {.start = 1.0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
