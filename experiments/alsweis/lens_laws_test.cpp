// SPDX-License-Identifier: MIT
#include "experiments/alsweis/lens_laws.hpp"

#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::experiments::alsweis {
namespace {

namespace oracles = phytobench::oracles::alsweis;

template <class Area>
LensViolations violations(const Area& area, std::uint64_t seed = 0, int pairs = 2'000) {
  CounterStream stream(seed, 2);
  return lens_violations(area, stream, pairs);
}

TEST(LensLaws, HoldForTheAreaWithAnySeed) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const LensViolations of = violations(lens_area, seed);
    EXPECT_EQ(of.asymmetry, 0.0);
    EXPECT_EQ(of.scaling_by_powers_of_two, 0.0);
    EXPECT_LE(of.scaling_by_three_over_bound, 1.0) << seed;
    EXPECT_LE(of.rise_with_distance, 2.1e-14);
    EXPECT_LE(of.excess_over_small_disc, 2.1e-14);
    EXPECT_LE(of.step_over_bound, 1.0) << seed;
  }
}

TEST(LensLaws, BoundOfScalingIsNearWhatHappens) {
  EXPECT_GT(violations(lens_area).scaling_by_three_over_bound, 0.1);
}

// It is homogeneous, too; what breaks is that it is one continuous function and fits its disc.
TEST(LensLaws, FailForThePrintedArea) {
  const LensViolations of = violations([](double r, double s, double d) {
    return oracles::equation_a4_as_printed(std::min(r, s), std::max(r, s), d);
  });
  EXPECT_EQ(of.scaling_by_powers_of_two, 0.0);
  EXPECT_GT(of.excess_over_small_disc, 0.5);
  EXPECT_GT(of.step_over_bound, 1e6);
}

TEST(LensLaws, FailForAWrongPowerOfARadius) {
  const LensViolations of =
      violations([](double r, double s, double d) { return lens_area(r, s, d) / r; });
  EXPECT_GT(of.asymmetry, 0.1);
  EXPECT_GT(of.scaling_by_powers_of_two, 0.5);
  EXPECT_GT(of.scaling_by_three_over_bound, 1e6);
}

TEST(LensLaws, FailForALengthThatDoesNotScale) {
  const LensViolations of =
      violations([](double r, double s, double d) { return lens_area(r, s, d + 1e-12); });
  EXPECT_GT(of.scaling_by_powers_of_two, 1e-3);
  EXPECT_GT(of.scaling_by_three_over_bound, 100.0);
}

TEST(LensLaws, FailForWhatCancelsNearContact) {
  const LensViolations of = violations(oracles::equation_a4_corrected, 0, 20'000);
  EXPECT_GT(of.scaling_by_three_over_bound, 1.5);
}

TEST(LensLaws, FailForWhatIsNoNumber) {
  const LensViolations of = violations([](double, double, double) { return std::nan(""); });
  EXPECT_EQ(of.step_over_bound, HUGE_VAL);
  EXPECT_EQ(of.scaling_by_three_over_bound, HUGE_VAL);
}

// By differences of the area itself.
TEST(LensCondition, IsTheSumOfTheSlopes) {
  CounterStream stream(3, 0);
  for (int i = 0; i < 200; ++i) {
    const CrossingCircles c = random_crossing(stream);
    const auto [r, s, d] = c;
    const double step = 1e-4 * std::min(r + s - d, d - std::abs(r - s)), a = lens_area(r, s, d);
    const double by_r = (lens_area(r + step, s, d) - lens_area(r - step, s, d)) / (2 * step);
    const double by_s = (lens_area(r, s + step, d) - lens_area(r, s - step, d)) / (2 * step);
    const double by_d = (lens_area(r, s, d + step) - lens_area(r, s, d - step)) / (2 * step);
    const double slopes = (r * by_r + s * by_s - d * by_d) / a;
    EXPECT_NEAR(slopes / lens_condition(c, a), 1.0, 1e-5);
  }
}

TEST(ChordBound, HoldsForThePrintedAnglesAndIsNearWhatHappens) {
  CounterStream stream(4, 0);
  double over_bound = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const CrossingCircles c = random_crossing(stream);
    const double error = std::abs(
        2.0 * c.r * std::sin(oracles::equation_a2(c.r, c.s, c.distance) / 2.0) - common_chord(c));
    // The chord itself loses a little in its differences, which are no smaller than 2e-5.
    const double chord_rounding = 1e5 * rounding * common_chord(c);
    keep_larger(over_bound, error / (chord_bound(c) + chord_rounding));
  }
  EXPECT_LE(over_bound, 1.0);
  EXPECT_GT(over_bound, 0.01);
}

}  // namespace
}  // namespace phytobench::experiments::alsweis
