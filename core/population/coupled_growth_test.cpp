// SPDX-License-Identifier: MIT
#include "core/population/coupled_growth.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/growth_integrators.hpp"
#include "core/population/richards_growth.hpp"
#include "core/statistics/gini.hpp"

namespace phytobench {
namespace {

using Sizes = std::vector<double>;

constexpr double asymmetries[] = {0.0, 0.5, 1.0, 1.5, 2.0, 3.0};
constexpr double coupled_shapes[] = {0.5, 1.0, 2.0, 3.0};

Sizes grown(const CoupledGrowth& growth, const OverlapShares& shares, const Sizes& start,
            double time, std::size_t steps = 2000) {
  return integrated(RungeKutta4{}, start, time, steps, [&](const Sizes& sizes) {
    return coupled_growth_rates(growth, shares, sizes);
  });
}

TEST(CoupledGrowthLaw, WithoutNeighboursIsRichardsLaw) {
  for (const double shape : coupled_shapes) {
    const Sizes sizes{0.3, 4.0, 9.0};
    const Sizes rates =
        coupled_growth_rates({0.1, 10.0, shape, 1.0}, OverlapShares::none(3), sizes);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      EXPECT_NEAR(rates[i], richards_rate({0.1, 10.0, shape}, sizes[i]), 1e-15);
  }
}

TEST(CoupledGrowthLaw, SharingEverythingNeutrallyTheSumIsOnePlant) {
  for (const double shape : coupled_shapes) {
    const Sizes start{0.5, 1.0, 1.5};
    const Sizes end = grown({0.1, 10.0, shape, 1.0}, OverlapShares::complete(3), start, 30.0);
    const double one = richards_size({0.1, 10.0, shape}, 3.0, 30.0);
    for (std::size_t i = 0; i < start.size(); ++i)
      EXPECT_NEAR(end[i], one * start[i] / 3.0, 1e-9) << shape;
  }
}

TEST(CoupledGrowthLaw, SharingEverythingKeepsDifferencesOfTheConservedScale) {
  for (const double shape : coupled_shapes)
    for (const double a : asymmetries) {
      const Sizes start{1.0, 1.5, 2.0};
      const Sizes end = grown({0.05, 10.0, shape, a}, OverlapShares::complete(3), start, 20.0);
      for (std::size_t i = 1; i < 3; ++i)
        EXPECT_NEAR(conserved_scale(end[i], a) - conserved_scale(end[0], a),
                    conserved_scale(start[i], a) - conserved_scale(start[0], a), 1e-8)
            << shape << " " << a;
      if (a == 0.0) {
        EXPECT_NEAR(end[1] - end[0], 0.5, 1e-9);
      }
      if (a == 1.0) {
        EXPECT_NEAR(end[1] / end[0], 1.5, 1e-9);
      }
    }
}

// Factors before the bracket that are not 0 leave the bracket 0: the pressure of every plant is w.
TEST(CoupledGrowthLaw, EndsWhereEveryPressureIsTheFinalSize) {
  const OverlapShares shares(3, {1.0, 0.3, 0.1, 0.2, 1.0, 0.4, 0.1, 0.3, 1.0});
  for (const double shape : coupled_shapes)
    for (const double a : asymmetries) {
      const Sizes end = grown({0.1, 10.0, shape, a}, shares, {1.0, 1.5, 2.0}, 3000.0, 15'000);
      for (std::size_t i = 0; i < 3; ++i) {
        double pressure = 0.0;
        for (std::size_t j = 0; j < 3; ++j) pressure += shares.of(i)[j] * end[j];
        EXPECT_NEAR(pressure, 10.0, 1e-6) << shape << " " << a;
      }
    }
}

TEST(CoupledGrowthLaw, PassesShapeOneWithoutAGap) {
  const Sizes sizes{1.0, 2.0};
  const auto shares = OverlapShares::complete(2);
  const double at = coupled_growth_rates({0.1, 10.0, 1.0, 1.0}, shares, sizes)[0];
  EXPECT_NEAR(at, 0.1 * (std::log(10.0) - std::log(3.0)), 1e-16);
  // The next term of the quotient.
  const double x = std::log(0.3);
  for (const double e : {1e-3, 1e-6, -1e-9, 1e-13}) {
    const double bend = (1.0 + e) - 1.0;
    const double off = coupled_growth_rates({0.1, 10.0, 1.0 + e, 1.0}, shares, sizes)[0] - at;
    EXPECT_NEAR(off, -0.1 * x * x * bend / 2.0, 0.1 * bend * bend + 1e-16);
  }
}

TEST(CoupledGrowthLaw, MoreOverlapNeverMakesAPlantGrowFaster) {
  const Sizes sizes{1.0, 2.0};
  double last = 1e9;
  for (const double share : {0.0, 0.2, 0.5, 1.0}) {
    const OverlapShares shares(2, {1.0, share, 0.5, 1.0});
    const Sizes rates = coupled_growth_rates({0.1, 10.0, 2.0, 1.0}, shares, sizes);
    EXPECT_LT(rates[0], last);
    EXPECT_NEAR(rates[1], 0.1 * 2.0 * (1.0 - 2.5 / 10.0), 1e-15) << "has a share of its own";
    last = rates[0];
  }
}

TEST(CoupledGrowthLaw, UnitsOfAreaCancelForTheNeutralAsymmetry) {
  const OverlapShares shares(2, {1.0, 0.4, 0.2, 1.0});
  const Sizes metres = coupled_growth_rates({0.1, 10.0, 3.0, 1.0}, shares, Sizes{1.0, 2.0});
  const Sizes centimetres = coupled_growth_rates({0.1, 1e5, 3.0, 1.0}, shares, Sizes{1e4, 2e4});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(centimetres[i], 1e4 * metres[i], 1e-11);
}

TEST(SizeFactor, IsAPowerThatKnowsTheCaseOfZero) {
  EXPECT_EQ(size_factor(7.0, 0.0), 1.0);
  EXPECT_EQ(size_factor(7.0, 1.0), 7.0);
  EXPECT_NEAR(size_factor(7.0, 1e-9), 1.0, 1e-8);
  EXPECT_NEAR(size_factor(3.0 * 7.0, 1.5), std::pow(3.0, 1.5) * size_factor(7.0, 1.5), 1e-12);
}

TEST(EndSizesOfTwo, AreWhereTheGrowthEnds) {
  for (const double shape : {1.0, 2.0})
    for (const double a : asymmetries) {
      const double rate = 0.1 * std::pow(5.0, 1.0 - a);  // about as fast for every a
      const Sizes end =
          grown({rate, 10.0, shape, a}, OverlapShares::complete(2), {1.0, 2.0}, 600.0, 12'000);
      const auto [small, large] = end_sizes_of_two(10.0, a, {1.0, 2.0});
      EXPECT_NEAR(end[0], small, 1e-7) << shape << " " << a;
      EXPECT_NEAR(end[1], large, 1e-7) << shape << " " << a;
    }
}

TEST(EndSizesOfTwo, AreThoseByHand) {
  const auto [a0_small, a0_large] = end_sizes_of_two(10.0, 0.0, {1.0, 2.0});
  EXPECT_NEAR(a0_small, 4.5, 1e-14);
  EXPECT_NEAR(a0_large, 5.5, 1e-14);
  EXPECT_NEAR(end_sizes_of_two(10.0, 1.0, {1.0, 2.0}).first, 10.0 / 3.0, 1e-14);
  // 1/v1 - 1/v2 = 1/2 and v1 + v2 = 10.
  EXPECT_NEAR(end_sizes_of_two(10.0, 2.0, {1.0, 2.0}).first, 7.0 - std::sqrt(29.0), 1e-14);
  EXPECT_NEAR(end_sizes_of_two(10.0, 2.0, {3.0, 3.0}).first, 5.0, 1e-14);
  EXPECT_NEAR(end_sizes_of_two(10.0, 2.0, {4.0, 6.0}).first, 4.0, 1e-14) << "already there";
}

TEST(EndSizesOfTwoLaw, DifferTheMoreTheLargerTheAsymmetry) {
  double last = 0.0;
  for (const double a : {0.0, 0.5, 0.999, 1.0, 1.001, 1.5, 2.0, 3.0, 10.0}) {
    const auto [small, large] = end_sizes_of_two(10.0, a, {1.0, 2.0});
    const double gini = gini_coefficient(Sizes{small, large});
    EXPECT_GT(gini, last) << a;
    EXPECT_EQ(a < 1.0, gini < 1.0 / 6.0 - 1e-9) << a;
    EXPECT_EQ(a > 1.0, gini > 1.0 / 6.0 + 1e-9) << a;
    last = gini;
  }
}

TEST(CoupledGrowthInput, IsRefusedWhereTheLawHasNoValue) {
  EXPECT_THROW(OverlapShares(2, {1.0, 0.0, 0.0}), ContractViolation);
  EXPECT_THROW(OverlapShares(2, {1.0, 0.0, 0.0, 0.9}), ContractViolation) << "the plant itself";
  EXPECT_THROW(OverlapShares(2, {1.0, 1.1, 0.0, 1.0}), ContractViolation) << "an area, no share";
  const auto shares = OverlapShares::complete(2);
  EXPECT_THROW(coupled_growth_rates({}, shares, Sizes{1.0}), ContractViolation);
  EXPECT_THROW(coupled_growth_rates({}, shares, Sizes{1.0, 0.0}), ContractViolation);
  EXPECT_THROW(coupled_growth_rates({.rate = 0.0}, shares, Sizes{1.0, 1.0}), ContractViolation);
  EXPECT_THROW(coupled_growth_rates({.asymmetry = -1.0}, shares, Sizes{1.0, 1.0}),
               ContractViolation);
  EXPECT_THROW(end_sizes_of_two(10.0, 1.0, {2.0, 1.0}), ContractViolation);
  EXPECT_THROW(end_sizes_of_two(10.0, 1.0, {5.0, 6.0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
