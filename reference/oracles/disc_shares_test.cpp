// SPDX-License-Identifier: MIT
#include "reference/oracles/disc_shares.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/oracles/test_noise.hpp"

namespace phytobench::oracles {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<OracleDisc> scene_of_large_discs(unsigned count, unsigned salt) {
  std::vector<OracleDisc> discs;
  for (unsigned i = 0; i < count; ++i)
    discs.push_back(
        {10 * noise(3 * i + salt), 8 * noise(3 * i + 1 + salt), 0.5 + 2 * noise(3 * i + 2 + salt)});
  return discs;
}

TEST(DiscSharesOracle, StripsAgreeWithSquares) {
  for (const OracleGround ground : {OracleGround{}, OracleGround{10, 8}})
    for (const double exponent : {0.0, 1.0, 3.5, infinite}) {
      const std::vector<OracleDisc> discs = scene_of_large_discs(7, 5);
      const auto strips = disc_shares_by_strips(discs, ground, exponent);
      const auto squares = disc_shares_by_squares(discs, ground, exponent, 150);
      double largest = 0.0;
      for (std::size_t i = 0; i < discs.size(); ++i) {
        const double area = pi * discs[i].r * discs[i].r;
        EXPECT_NEAR(strips[i], squares[i], 2e-3 * area) << i;
        largest = std::fmax(largest, 1 - strips[i] / area);
      }
      EXPECT_GT(largest, 0.3);  // there is something to share
    }
}

TEST(DiscSharesOracle, LensOfTwoUnitCirclesIsShared) {
  const double lens = 2 * pi / 3 - std::sqrt(3) / 2;  // at distance 1
  const std::vector<OracleDisc> two = {{0, 0, 1}, {0.6, 0.8, 1}};
  for (const double exponent : {0.0, 1.0, infinite})
    for (const double won : disc_shares_by_strips(two, {}, exponent))
      EXPECT_NEAR(won, pi - lens / 2, 1e-13);
}

TEST(DiscSharesOracle, NestedDiscsHaveClosedForms) {
  const std::vector<OracleDisc> nested = {{0, 0, 3}, {0.3, 0.2, 2}, {0.3, 0.1, 1}};
  const auto equal = disc_shares_by_strips(nested, {}, 0.0);
  EXPECT_NEAR(equal[0], pi * (5 + 3.0 / 2 + 1.0 / 3), 1e-12);
  EXPECT_NEAR(equal[1], pi * (3.0 / 2 + 1.0 / 3), 1e-12);
  EXPECT_NEAR(equal[2], pi / 3, 1e-12);
  const auto by_size = disc_shares_by_strips(nested, {}, 1.0);
  EXPECT_NEAR(by_size[0], pi * (5 + 3 * 9.0 / 13 + 9.0 / 14), 1e-12);
  EXPECT_NEAR(by_size[1], pi * (3 * 4.0 / 13 + 4.0 / 14), 1e-12);
  EXPECT_NEAR(by_size[2], pi / 14, 1e-12);
  const auto winner = disc_shares_by_strips(nested, {}, infinite);
  EXPECT_NEAR(winner[0], 9 * pi, 1e-12);
  EXPECT_EQ(winner[1], 0.0);
  EXPECT_EQ(winner[2], 0.0);
}

/// Across the border the two are the same two as in the open.
TEST(DiscSharesOracle, ATorusHasNoBorder) {
  const OracleGround ground{10, 8};
  const auto across = disc_shares_by_strips({{9.8, 7.9, 1.5}, {0.6, 0.7, 1}}, ground, 2.0);
  const auto inside = disc_shares_by_strips({{4.8, 3.9, 1.5}, {5.6, 4.7, 1}}, {}, 2.0);
  EXPECT_NEAR(across[0], inside[0], 1e-12);
  EXPECT_NEAR(across[1], inside[1], 1e-12);
}

}  // namespace
}  // namespace phytobench::oracles
