// SPDX-License-Identifier: MIT
#include "core/population/richards_growth.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/growth_integrators.hpp"

namespace phytobench {
namespace {

constexpr double richards_shapes[] = {-1.0, 0.0, 0.5, 2.0 / 3.0, 1.0, 1.5, 2.0, 3.0, 5.0};

/// The printed form, for shapes other than 1.
double printed_rate(const RichardsGrowth& growth, double v) {
  return growth.rate / (1.0 - growth.shape) * v *
         (std::pow(v / growth.final_size, growth.shape - 1.0) - 1.0);
}

TEST(RichardsRate, IsThePrintedForm) {
  for (const double shape : {-1.0, 0.0, 0.5, 1.5, 2.0, 3.0})
    for (const double size : {0.01, 1.0, 5.0, 9.9, 10.0, 25.0}) {
      const RichardsGrowth growth{0.1, 10.0, shape};
      const double expected = printed_rate(growth, size);
      EXPECT_NEAR(richards_rate(growth, size), expected, 1e-13 * std::abs(expected) + 1e-15);
    }
}

TEST(RichardsRate, IsLogisticMonomolecularAndGompertzianWhereItShouldBe) {
  for (const double v : {0.1, 3.0, 10.0, 14.0}) {
    EXPECT_NEAR(richards_rate({0.3, 10.0, 2.0}, v), 0.3 * v * (1.0 - v / 10.0), 1e-14);
    EXPECT_NEAR(richards_rate({0.3, 10.0, 0.0}, v), 0.3 * (10.0 - v), 1e-14);
    EXPECT_NEAR(richards_rate({0.3, 10.0, 1.0}, v), -0.3 * v * std::log(v / 10.0), 1e-14);
  }
}

TEST(RichardsRateLaw, VanishesAtTheFinalSizeAndFallsThereWithRateK) {
  for (const double shape : richards_shapes) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    EXPECT_EQ(richards_rate(growth, 10.0), 0.0);
    const double h = 1e-6;
    const double slope =
        (richards_rate(growth, 10.0 + h) - richards_rate(growth, 10.0 - h)) / (2.0 * h);
    EXPECT_NEAR(slope, -0.1, 1e-9) << shape;
  }
}

// Where the printed form divides 0 by 0. The next term of the quotient, -k v x^2 e / 2, is left.
TEST(RichardsRateLaw, PassesShapeOneWithoutLosingDigits) {
  const double v = 3.0, x = std::log(0.3);
  const double gompertz = richards_rate({0.1, 10.0, 1.0}, v);
  for (const double e : {1e-3, -1e-3, 1e-6, -1e-6, 1e-9, 1e-12, -1e-15}) {
    const double shape = 1.0 + e, bend = shape - 1.0;
    EXPECT_NEAR(richards_rate({0.1, 10.0, shape}, v) - gompertz, -0.1 * v * x * x * bend / 2.0,
                0.1 * bend * bend + 1e-16);
  }
}

TEST(RichardsSize, IsTheClosedFormOfThePrintedLaw) {
  struct Case {
    double shape, after_10, after_20, after_50;
  };
  for (const Case& c :
       {Case{0.5, 5.601838, 8.234864, 9.908068}, Case{1.0, 4.286675, 7.322590, 9.846050},
        Case{2.0, 2.319693, 4.508531, 9.428256}, Case{3.0, 1.634736, 2.635397, 7.745060}}) {
    const RichardsGrowth growth{0.1, 10.0, c.shape};
    EXPECT_NEAR(richards_size(growth, 1.0, 10.0), c.after_10, 5e-7);
    EXPECT_NEAR(richards_size(growth, 1.0, 20.0), c.after_20, 5e-7);
    EXPECT_NEAR(richards_size(growth, 1.0, 50.0), c.after_50, 5e-7);
  }
}

TEST(RichardsSizeLaw, StartsAtTheStartAndEndsAtTheFinalSize) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double shape : richards_shapes)
    for (const double start : {1e-30, 1e-3, 1.0, 9.999999, 10.0, 30.0}) {
      const RichardsGrowth growth{0.1, 10.0, shape};
      EXPECT_NEAR(richards_size(growth, start, 0.0) / start, 1.0, 4e-14) << shape;
      EXPECT_EQ(richards_size(growth, start, infinity), 10.0) << shape << " " << start;
    }
}

TEST(RichardsSizeLaw, TwoTimesInARowAreTheirSum) {
  for (const double shape : richards_shapes)
    for (const double start : {1e-6, 0.5, 9.0, 15.0}) {
      const RichardsGrowth growth{0.1, 10.0, shape};
      const double twice = richards_size(growth, richards_size(growth, start, 7.0), 13.0);
      EXPECT_NEAR(twice / richards_size(growth, start, 20.0), 1.0, 1e-13) << shape << " " << start;
    }
}

TEST(RichardsSizeLaw, ItsSlopeIsTheRate) {
  for (const double shape : richards_shapes) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    const double h = 1e-4, size = richards_size(growth, 1.0, 8.0);
    const double slope =
        (richards_size(growth, 1.0, 8.0 + h) - richards_size(growth, 1.0, 8.0 - h)) / (2.0 * h);
    EXPECT_NEAR(slope, richards_rate(growth, size), 1e-9) << shape;
  }
}

TEST(RichardsSizeLaw, UnitsOfSizeAndTimeCancel) {
  for (const double shape : richards_shapes) {
    const double plain = richards_size({0.1, 10.0, shape}, 1.0, 20.0);
    EXPECT_NEAR(richards_size({0.1, 1e5, shape}, 1e4, 20.0), 1e4 * plain, 1e4 * plain * 1e-14);
    EXPECT_NEAR(richards_size({0.1 / 365.0, 10.0, shape}, 1.0, 7300.0), plain, plain * 1e-13);
  }
}

TEST(RichardsSizeLaw, FallsWithTheShapeForGrowingPlants) {
  for (const double time : {10.0, 20.0, 50.0}) {
    double last = 10.0;
    for (double shape = -1.0; shape <= 5.0; shape += 0.125) {
      const double size = richards_size({0.1, 10.0, shape}, 1.0, time);
      EXPECT_LT(size, last);
      last = size;
    }
  }
}

TEST(RichardsSizeLaw, NearsGompertzLawInProportionToTheShapesDistance) {
  const double gompertz = richards_size({0.1, 10.0, 1.0}, 1.0, 20.0);
  double last = 0.0;
  for (const double e : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const double off = gompertz - richards_size({0.1, 10.0, 1.0 + e}, 1.0, 20.0);
    if (last > 0.0) {
      EXPECT_NEAR(std::log10(last / off), 1.0, 0.02);
    }
    last = off;
  }
  // A few last digits of the shape move the size by as little.
  EXPECT_NEAR(richards_size({0.1, 10.0, 1.0 + 1e-15}, 1.0, 20.0), gompertz, 1e-14);
}

TEST(RichardsSizeLaw, AConstantCompetitionFactorSlowsTheClock) {
  for (const double shape : richards_shapes) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    const double factor = 0.35;
    const auto pressed = [&](double v) { return factor * richards_rate(growth, v); };
    EXPECT_NEAR(integrated(RungeKutta4{}, 1.0, 40.0, 4000, pressed),
                richards_size(growth, 1.0, factor * 40.0), 1e-9)
        << shape;
  }
}

/// The largest value of the rate by golden sections.
double place_of_largest(const RichardsGrowth& growth) {
  double low = 1e-9, high = growth.final_size;
  for (int i = 0; i < 80; ++i) {
    const double width = (high - low) / std::numbers::phi;
    if (richards_rate(growth, high - width) < richards_rate(growth, low + width))
      low = high - width;
    else
      high = low + width;
  }
  return 0.5 * (low + high);
}

TEST(RichardsInflection, IsWhereGrowthIsFastest) {
  for (const double shape : {0.1, 0.5, 1.0, 1.0 + 1e-12, 2.0, 3.0, 10.0}) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    EXPECT_NEAR(*richards_inflection_size(growth), place_of_largest(growth), 1e-6) << shape;
    EXPECT_NEAR(*richards_largest_rate(growth),
                richards_rate(growth, *richards_inflection_size(growth)), 1e-14);
  }
  EXPECT_NEAR(*richards_inflection_size({0.1, 10.0, 1.0}), 10.0 / std::numbers::e, 1e-14);
  EXPECT_NEAR(*richards_inflection_size({0.1, 10.0, 2.0}), 5.0, 1e-14);
  EXPECT_NEAR(*richards_inflection_size({0.1, 27.0, 2.0 / 3.0}), 8.0, 1e-13) << "Bertalanffy";
}

TEST(RichardsInflection, IsMissingWhereGrowthSlowsDownFromTheStart) {
  EXPECT_FALSE(richards_inflection_size({0.1, 10.0, 0.0}));
  EXPECT_FALSE(richards_inflection_size({0.1, 10.0, -1.0}));
  EXPECT_FALSE(richards_largest_rate({0.1, 10.0, -1.0}));
  EXPECT_NEAR(*richards_largest_rate({0.1, 10.0, 0.0}), 1.0, 1e-15);
  EXPECT_NEAR(*richards_largest_rate({0.1, 10.0, 1e-9}), 1.0, 1e-7);
}

TEST(RichardsRateLaw, ItsMeanOverAllSizesIsKnown) {
  for (const double shape : {0.5, 1.0, 2.0, 3.0}) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    // In u = sqrt(v) the integrand is smooth enough for the midpoint rule.
    constexpr int pieces = 20'000;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      const double u = std::sqrt(10.0) * (i + 0.5) / pieces;
      sum += richards_rate(growth, u * u) * 2.0 * u;
    }
    EXPECT_NEAR(sum * std::sqrt(10.0) / pieces / 10.0, 0.1 * 10.0 / (2.0 * (shape + 1.0)), 1e-8);
  }
}

TEST(RichardsInitialRate, ExistsAboveShapeOneOnly) {
  for (const double shape : {1.5, 2.0, 3.0}) {
    const RichardsGrowth growth{0.1, 10.0, shape};
    const double v = 1e-24;
    EXPECT_NEAR(*richards_initial_relative_rate(growth), richards_rate(growth, v) / v, 1e-12);
  }
  EXPECT_FALSE(richards_initial_relative_rate({0.1, 10.0, 1.0}));
  EXPECT_FALSE(richards_initial_relative_rate({0.1, 10.0, 0.5}));
}

TEST(RadiusGrowth, IsLogisticWithAQuarterOfTheNamedRate) {
  const RichardsGrowth growth = radius_growth(0.05, 0.5);
  for (const double r : {0.01, 0.2, 0.5})
    EXPECT_NEAR(richards_rate(growth, r), 0.05 * r / 0.5 * (1.0 - r / 0.5), 1e-16);
  EXPECT_NEAR(*richards_largest_rate(growth), 0.0125, 1e-16);
  EXPECT_NEAR(richards_size(growth, 0.05, 60.0), 0.489089, 5e-7);
}

TEST(RichardsGrowthInput, IsRefusedWhereTheLawHasNoValue) {
  const double none = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const RichardsGrowth& wrong :
       {RichardsGrowth{0.0, 10.0, 2.0}, RichardsGrowth{0.1, 0.0, 2.0},
        RichardsGrowth{0.1, 10.0, none}, RichardsGrowth{infinity, 10.0, 2.0},
        RichardsGrowth{0.1, infinity, 2.0}}) {
    EXPECT_FALSE(is_valid(wrong));
    EXPECT_THROW(richards_rate(wrong, 1.0), ContractViolation);
    EXPECT_THROW(richards_inflection_size(wrong), ContractViolation);
  }
  EXPECT_THROW(richards_rate({0.1, 10.0, 2.0}, 0.0), ContractViolation);
  EXPECT_THROW(richards_size({0.1, 10.0, 2.0}, -1.0, 1.0), ContractViolation);
  EXPECT_THROW(richards_size({0.1, 10.0, 2.0}, 1.0, -1.0), ContractViolation);
  EXPECT_THROW(radius_growth(0.05, 0.0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
