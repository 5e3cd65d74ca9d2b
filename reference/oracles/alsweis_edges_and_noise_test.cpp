// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_edges_and_noise.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace phytobench::oracles::alsweis {
namespace {

TEST(LiteralSobel, GivesTheGradientsOfSimplePictures) {
  EXPECT_EQ(equation_b1_first_line({0, 0, 1, 0, 0, 1, 0, 0, 1}), 4);  // upright step
  EXPECT_EQ(equation_b1_second_line({0, 0, 1, 0, 0, 1, 0, 0, 1}), 16);
  EXPECT_EQ(equation_b1_first_line({0, 1, 2, 0, 1, 2, 0, 1, 2}), 8);  // ramp of slope 1
  EXPECT_DOUBLE_EQ(equation_b1_first_line({0, 0, 0, 0, 1, 1, 0, 1, 1}), std::sqrt(18.0));
}

TEST(LiteralSobel, IgnoresBrightnessAndTurns) {
  const Neighbourhood z{3, 1, 4, 1, 5, 9, 2, 6, 5};
  Neighbourhood brighter = z;
  for (double& value : brighter) value += 7;
  const Neighbourhood turned{z[6], z[3], z[0], z[7], z[4], z[1], z[8], z[5], z[2]};
  EXPECT_EQ(equation_b1_first_line(brighter), equation_b1_first_line(z));
  EXPECT_EQ(equation_b1_first_line(turned), equation_b1_first_line(z));
  EXPECT_EQ(equation_b1_first_line({5, 5, 5, 5, 5, 5, 5, 5, 5}), 0);
}

TEST(LiteralSobel, RespondsToBlackAndWhiteWithAtMostTheRootOfTwenty) {
  double largest = 0;
  for (unsigned bits = 0; bits < 512; ++bits) {
    Neighbourhood z{};
    for (unsigned i = 0; i < 9; ++i) z[i] = (bits >> i) & 1u;
    largest = std::fmax(largest, equation_b1_first_line(z));
  }
  EXPECT_DOUBLE_EQ(largest, std::sqrt(20.0));
}

TEST(LiteralNoise, MeetsItsKnots) {
  EXPECT_EQ(cosine_interpolant(0.2, 0.9, 0), 0.2);
  EXPECT_NEAR(cosine_interpolant(0.2, 0.9, 1), 0.9, 1e-12);
  EXPECT_NEAR(cosine_interpolant(0.2, 0.9, 0.5), 0.55, 1e-7);
  EXPECT_EQ(linear_interpolant(0.2, 0.9, 0), 0.2);
  EXPECT_EQ(linear_interpolant(0.2, 0.9, 1), 0.9);
}

TEST(LiteralNoise, IsOnceDifferentiableForTheCosineOnly) {
  const double a = 0.1, b = 0.8, c = 0.4, h = 1e-4;
  const double before = (cosine_interpolant(a, b, 1) - cosine_interpolant(a, b, 1 - h)) / h;
  const double behind = (cosine_interpolant(b, c, h) - cosine_interpolant(b, c, 0)) / h;
  EXPECT_NEAR(before, 0, 1e-3);
  EXPECT_NEAR(behind, 0, 1e-3);
  EXPECT_DOUBLE_EQ(slope_jump_of_linear(a, b, c), -1.1);
  // Second derivatives: -(pi^2 / 2) (b - a) before and (pi^2 / 2) (c - b) behind the knot.
  const auto second = [](double p, double q, double x, double side) {
    const double k = 1e-3;
    return (cosine_interpolant(p, q, x) - 2 * cosine_interpolant(p, q, x + side * k) +
            cosine_interpolant(p, q, x + 2 * side * k)) /
           (k * k);
  };
  const double half_square = std::numbers::pi * std::numbers::pi / 2;
  EXPECT_NEAR(second(b, c, 0, 1) - second(a, b, 1, -1), half_square * (c - a), 0.01);
}

TEST(LiteralNoise, IsNotPerlinsAtItsKnots) {
  EXPECT_EQ(noise_at_knot(0.7, 0.1), 0.7);
  EXPECT_EQ(perlin_noise_at_knot(0.7), 0);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis
