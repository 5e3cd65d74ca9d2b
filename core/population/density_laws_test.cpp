// SPDX-License-Identifier: MIT
#include "core/population/density_laws.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double densities[] = {0.0, 0.01, 1.0, 7.0, 100.0, 1e6};

TEST(CrowdingDeathsLaw, LeaveMoreOfMoreButNeverMoreThanTheHighestDensity) {
  double last = -1.0;
  for (const double x : densities) {
    const double left = surviving_density(x, 0.01);
    EXPECT_GT(left, last);
    EXPECT_LT(left, 100.0);
    EXPECT_LE(left, x);
    last = left;
  }
  EXPECT_NEAR(surviving_density(1e18, 0.01), 100.0, 1e-12);
  EXPECT_EQ(surviving_density(100.0, 0.01), 50.0);
  EXPECT_EQ(surviving_density(7.0, 0.0), 7.0);
}

TEST(CrowdingDeathsLaw, InARowAddUp) {
  double x = 1000.0;
  for (int n = 1; n <= 20; ++n) {
    x = surviving_density(x, 0.01);
    EXPECT_NEAR(x, surviving_density(1000.0, 0.01 * n), 1e-12 * x);
  }
}

TEST(OtherDeathsLaw, ComeBeforeCrowding) {
  for (const double x : densities) {
    EXPECT_EQ(surviving_density(x, 0.01, 1.0), surviving_density(x, 0.01));
    EXPECT_EQ(surviving_density(x, 0.01, 0.0), 0.0);
    if (x > 0.0) {
      EXPECT_GT(surviving_density(x, 0.01, 0.5), 0.5 * surviving_density(x, 0.01));
    }
  }
  EXPECT_NEAR(surviving_density(1000.0, 0.01, 0.5), 500.0 / 6.0, 1e-13);
  EXPECT_NEAR(surviving_density(1e18, 0.01, 0.5), 100.0, 1e-12) << "the same limit";
}

TEST(LinearFecundity, HasASlopeAndAStart) {
  EXPECT_EQ(linear_fecundity(0.0, 3.0, 2.0), 3.0);
  EXPECT_EQ(linear_fecundity(5.0, 3.0, 2.0), 13.0);
}

constexpr CrowdedFecundity humped{
    .isolation = 1.0, .crowding = 0.5, .density_exponent = 2.0, .root = 1.0};

TEST(CrowdedFecundityLaw, ToThePowerMinusThetaIsAStraightLineInThePowerOfDensity) {
  const CrowdedFecundity law{
      .isolation = 0.7, .crowding = 0.2, .density_exponent = 1.5, .root = 0.8};
  for (const double x : {0.0, 0.1, 1.0, 30.0}) {
    const double line = 0.7 + 0.2 * std::pow(x, 1.5);
    EXPECT_NEAR(std::pow(seeds_per_plant(law, x), -0.8), line, 1e-13 * line);
  }
}

TEST(CrowdedFecundityLaw, FallsWithDensityFromThatOfAPlantAlone) {
  EXPECT_EQ(seeds_per_plant({.isolation = 0.25, .root = 2.0}, 0.0), 2.0);
  double last = 2.0;
  for (const double x : densities) {
    const double seeds = seeds_per_plant(humped, x);
    EXPECT_LT(seeds, last);
    last = seeds;
  }
}

TEST(SeedsPerArea, AreHighestWhereTheySay) {
  const double best = *density_of_most_seeds(humped);
  EXPECT_NEAR(best, std::numbers::sqrt2, 1e-15);
  EXPECT_NEAR(seeds_per_area(humped, best), std::numbers::sqrt2 / 2.0, 1e-15);
  for (const double off : {0.5, 0.99, 1.01, 2.0})
    EXPECT_LT(seeds_per_area(humped, off * best), seeds_per_area(humped, best));
}

TEST(SeedsPerArea, EndAsTheExponentsSay) {
  EXPECT_EQ(limit_of_seeds_per_area(humped), 0.0);
  const CrowdedFecundity even{.isolation = 1.0, .crowding = 0.25, .root = 1.0};
  EXPECT_EQ(limit_of_seeds_per_area(even), 4.0);
  EXPECT_NEAR(seeds_per_area(even, 1e15), 4.0, 1e-12);
  EXPECT_FALSE(density_of_most_seeds(even));
  const CrowdedFecundity weak{.crowding = 1.0, .density_exponent = 0.5, .root = 1.0};
  EXPECT_FALSE(limit_of_seeds_per_area(weak));
  EXPECT_GT(seeds_per_area(weak, 1e12), 1e5);
  EXPECT_FALSE(limit_of_seeds_per_area({.crowding = 0.0}));
  EXPECT_FALSE(density_of_most_seeds({.crowding = 0.0, .density_exponent = 2.0}));
}

TEST(SelfThinningLaw, IsAStraightLineOfLogarithmsWithOneConstant) {
  const SelfThinning law{.factor = 80.0};
  for (const double density : {0.01, 0.5, 4.0, 300.0}) {
    const double weight = thinned_weight(law, density);
    EXPECT_NEAR(thinning_constant(1.5, weight, density), std::log10(80.0), 1e-14);
    EXPECT_NEAR(thinned_density(law, weight), density, 1e-14 * density);
    EXPECT_NEAR(thinned_weight(law, 4.0 * density), weight / 8.0, 1e-15 * weight);
    EXPECT_NEAR(thinned_yield(law, 4.0 * density), 0.5 * thinned_yield(law, density),
                1e-14 * thinned_yield(law, density));
  }
  EXPECT_NEAR(thinned_weight(law, 4.0), 10.0, 1e-14);
}

TEST(DensityLaws, RefuseWhatCannotBe) {
  EXPECT_THROW(surviving_density(-1.0, 0.1), ContractViolation);
  EXPECT_THROW(surviving_density(1.0, std::nan("")), ContractViolation);
  EXPECT_THROW(surviving_density(1.0, 0.1, 1.5), ContractViolation);
  EXPECT_THROW(linear_fecundity(-1.0, 0.0, 1.0), ContractViolation);
  EXPECT_THROW(seeds_per_plant({.isolation = 0.0}, 1.0), ContractViolation);
  EXPECT_THROW(seeds_per_area({}, -1.0), ContractViolation);
  EXPECT_THROW(limit_of_seeds_per_area({.root = 0.0}), ContractViolation);
  EXPECT_THROW(thinned_weight({}, 0.0), ContractViolation);
  EXPECT_THROW(thinned_density({.factor = -1.0}, 1.0), ContractViolation);
  EXPECT_THROW(thinning_constant(1.5, 0.0, 1.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
