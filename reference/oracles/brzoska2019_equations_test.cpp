// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_equations.hpp"

#include <gtest/gtest.h>

namespace phytobench::oracles::brzoska2019 {
namespace {

// The worked examples of the thesis, to the digits it prints.
TEST(PrintedEquationsOracle, GiveTheWorkedExamples) {
  EXPECT_NEAR(equation_17_as_printed(2, 1.2, -8, 8, 30, 0), 2.0, 5e-4);
  EXPECT_NEAR(equation_17_as_printed(2, 1.2, -8, 8, 30, 14), 1.655, 5e-4);
  EXPECT_NEAR(equation_17_as_printed(2, 1.2, -8, 8, 30, 29), 1.2, 5e-4);
  EXPECT_NEAR(sig(-0.276), 0.431, 5e-4);
}

TEST(PrintedEquationsOracle, SquaredInterpolationHasTheSameEnds) {
  EXPECT_NEAR(equation_17_corrected(2, 1.2, -50, 50, 30, 0), 2.0, 1e-12);
  EXPECT_NEAR(equation_17_corrected(2, 1.2, -50, 50, 30, 29), 1.2, 1e-12);
  EXPECT_GT(equation_17_corrected(2, 1.2, -8, 8, 30, 14),
            equation_17_as_printed(2, 1.2, -8, 8, 30, 14));
}

TEST(PrintedEquationsOracle, BaseVolumeOfSimpleCutsIsKnown) {
  EXPECT_NEAR(base_volume(0, 0), 4.0 / 3.0 * std::numbers::pi, 1e-15);
  EXPECT_NEAR(base_volume(0.5, 0), 2.0 / 3.0 * std::numbers::pi, 1e-15);
}

TEST(PrintedEquationsOracle, PointCountsOfTheTwoFormsMoveInOppositeDirections) {
  EXPECT_LT(equation_22_as_printed(100, 20), equation_22_as_printed(100, 10));
  EXPECT_GT(equation_22_corrected(100, 20), equation_22_corrected(100, 10));
}

}  // namespace
}  // namespace phytobench::oracles::brzoska2019
