// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/field_over_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench {
namespace {

/// A field of 1 all over is the area that both discs have in common.
TEST(FieldOverDisc, OfAFlatFieldIsTheOverlap) {
  for (const double distance : {0.0, 0.25, 1.0, 1.65, 2.9, 3.5})
    for (const double radius : {0.4, 1.0, 2.0, 5.0}) {
      const LiteralField flat{.stem = 1.3, .zone = 1.3, .at_rim = 0.1};
      const double overlap = oracles::alsweis::equation_a4_corrected(radius, flat.zone, distance);
      EXPECT_NEAR(field_over_disc(flat, radius, distance), overlap, 1e-12) << distance;
    }
}

/// exp(-c (r - stem)) times 2 pi r integrates in closed form.
TEST(FieldOverDisc, OfADiscAroundTheStemHasAClosedForm) {
  const LiteralField field{.stem = 0.2, .zone = 2.0, .at_rim = 0.1};
  const double c = std::log(10.0) / 1.8;
  for (const double radius : {0.1, 0.5, 2.0, 3.0}) {
    const double stem = std::min(radius, 0.2), r = std::min(radius, 2.0);
    double expected = std::numbers::pi * stem * stem;
    if (r > stem)
      expected += 2.0 * std::numbers::pi / (c * c) *
                  (1.0 + c * stem - (1.0 + c * r) * std::exp(-c * (r - stem)));
    EXPECT_NEAR(field_over_disc(field, radius, 0.0), expected, 1e-13) << radius;
  }
}

TEST(FieldOverDiscOracle, IsTheSumOverSmallSquares) {
  const LiteralField field{.stem = 0.3, .zone = 2.0, .at_rim = 0.2};
  constexpr int steps = 1000;
  for (const double distance : {0.2, 1.0, 2.5}) {
    double sum = 0.0;
    for (int row = 0; row < steps; ++row)
      for (int column = 0; column < steps; ++column) {
        const double x = -1.0 + 2.0 * (column + 0.5) / steps, y = -1.0 + 2.0 * (row + 0.5) / steps;
        const double r = std::hypot(distance + x, y);
        if (std::hypot(x, y) > 1.0 || r > field.zone) continue;
        sum += r <= field.stem ? 1.0 : std::exp(std::log(0.2) * (r - 0.3) / 1.7);
      }
    // Squares at the borders count in full or not at all.
    EXPECT_NEAR(field_over_disc(field, 1.0, distance), 4.0 * sum / steps / steps, 1e-3);
  }
}

}  // namespace
}  // namespace phytobench
