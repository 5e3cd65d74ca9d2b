// SPDX-License-Identifier: MIT
#include "reference/oracles/exact_kolmogorov.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench::oracles {
namespace {

constexpr double probability_rounding = 1e-13;

TEST(KolmogorovDistributionOracle, HasClosedFormsForOneAndTwoValues) {
  for (const double d : {0.51, 0.6, 0.75, 0.99})
    EXPECT_NEAR(kolmogorov_distribution(1, d), 2.0 * d - 1.0, probability_rounding);
  for (const double d : {0.26, 0.3, 0.49})
    EXPECT_NEAR(kolmogorov_distribution(2, d), 2.0 * std::pow(2.0 * d - 0.5, 2.0),
                probability_rounding);
  for (const double d : {0.5, 0.7, 0.9})
    EXPECT_NEAR(kolmogorov_distribution(2, d), 1.0 - 2.0 * std::pow(1.0 - d, 2.0),
                probability_rounding);
}

TEST(KolmogorovDistributionOracle, IsThePublishedExample) {
  constexpr double printed = 5e-7;  // Marsaglia, Tsang and Wang: six digits
  EXPECT_NEAR(kolmogorov_distribution(10, 0.274), 0.628480, printed);
}

// Critical values of Miller 1956, J. Am. Stat. Assoc. 51, table 1.
TEST(KolmogorovDistributionOracle, MeetsTheTable) {
  constexpr double printed = 5e-5;
  EXPECT_NEAR(kolmogorov_distribution(5, 0.56328), 0.95, printed);
  EXPECT_NEAR(kolmogorov_distribution(10, 0.40925), 0.95, printed);
  EXPECT_NEAR(kolmogorov_distribution(10, 0.48893), 0.99, printed);
  EXPECT_NEAR(kolmogorov_distribution(20, 0.29408), 0.95, printed);
  EXPECT_NEAR(kolmogorov_distribution(100, 0.13403), 0.95, printed);
}

}  // namespace
}  // namespace phytobench::oracles
