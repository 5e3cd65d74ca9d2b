// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/sky_view.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/shadow/test_terrains.hpp"

namespace phytobench {
namespace {

using namespace testing_terrains;

constexpr double one_degree = std::numbers::pi / 180.0;

template <class Height>
HeightField about_middle(int columns, int rows, const Height& height) {
  return made(columns, rows, 1.0, 1.0, 0, [&](int column, int row, double) {
    return height(column - columns / 2, row - rows / 2);
  });
}
double in_middle(const HeightField& field, const std::vector<double>& values) {
  return values[field.index(field.columns() / 2, field.rows() / 2)];
}

/// cos^2 H: a round wall, of which a vertex may stand up to a cell too far away.
TEST(SkyViewOracle, ARingWallLeavesTheSquaredCosine) {
  const double distance = 100.0;
  for (const double horizon : {30.0, 45.0, 5.7106}) {
    const double height = distance * std::tan(horizon * one_degree);
    const HeightField field = about_middle(
        207, 207, [&](int x, int y) { return std::hypot(x, y) >= distance ? height : 0.0; });
    const auto cosine_squared = [&](double d) { return d * d / (d * d + height * height); };
    const double found = in_middle(field, sky_view_factors(field));
    EXPECT_GE(found, cosine_squared(distance - 1.0));
    EXPECT_LE(found, cosine_squared(distance + 1.0));
    // A horizontal receiver is a tilted one without slope.
    const std::vector<SurfaceGradient> level(field.size());
    EXPECT_NEAR(in_middle(field, tilted_sky_view_factors(field, level)), found, 1e-12);
  }
}

TEST(SkyViewOracle, FlatGroundSeesAllOfTheSky) {
  const HeightField field(9, 7, 4.0, 4.0, 12.0);
  for (const double factor : sky_view_factors(field)) EXPECT_NEAR(factor, 1.0, 1e-15);
}

/// (1 + cos s) / 2 on the plane, and for the horizontal receiver half of the sky and the rest of
/// what the plane leaves: 1 - mean of sin^2.
TEST(SkyViewOracle, PlanesSeeAsMuchAsTheyAreLevel) {
  const int azimuths = 256;
  for (const double slope : {30.0, 45.0, 60.0})
    for (const double aspect : {0.0, 33.0, 90.0, 250.0}) {
      const SunDirection up = direction_of({0.0, aspect});
      const double rise = std::tan(slope * one_degree);
      const HeightField field =
          about_middle(41, 41, [&](int x, int y) { return rise * (x * up.east + y * up.south); });
      const std::vector<SurfaceGradient> gradients(field.size(), {rise * up.east, rise * up.south});
      const double tilted =
          in_middle(field, tilted_sky_view_factors(field, gradients, {.azimuths = azimuths}));
      // Midpoints of a curve with two kinks.
      EXPECT_NEAR(tilted, (1.0 + std::cos(slope * one_degree)) / 2.0, 4.0 / azimuths / azimuths)
          << slope << ", " << aspect;
      EXPECT_NEAR(in_middle(field, sky_view_factors(field, {.azimuths = azimuths})),
                  (1.0 + std::cos(slope * one_degree)) / 2.0, 4.0 / azimuths / azimuths);
    }
}

/// Where the ground does not hide the sky, the receiver's own back does.
TEST(SkyViewOracle, ATiltedReceiverOnFlatGroundIsItsOwnHorizon) {
  const HeightField field(5, 5, 1.0, 1.0);
  for (const double slope : {20.0, 70.0}) {
    const double rise = std::tan(slope * one_degree);
    const std::vector<SurfaceGradient> gradients(field.size(), {0.6 * rise, -0.8 * rise});
    EXPECT_NEAR(in_middle(field, tilted_sky_view_factors(field, gradients, {.azimuths = 256})),
                (1.0 + std::cos(slope * one_degree)) / 2.0, 1e-4);
  }
}

/// cos s for a horizontal receiver on the line of a V-valley, cos^2 s for one on its flank.
TEST(SkyViewOracle, ValleysLeaveTheCosineOfTheirSlopes) {
  for (const double slope : {30.0, 60.0}) {
    const double rise = std::tan(slope * one_degree), cosine = std::cos(slope * one_degree);
    const HeightField field =
        about_middle(101, 201, [&](int x, int) { return rise * std::abs(x); });
    const auto level = sky_view_factors(field);
    EXPECT_NEAR(level[field.index(50, 100)], cosine, 1e-3) << slope;
    std::vector<SurfaceGradient> gradients;
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < field.columns(); ++column)
        gradients.push_back({column < 50 ? -rise : rise, 0.0});
    // The other flank ends fifty cells away, seen from one cell above the line.
    EXPECT_NEAR(tilted_sky_view_factors(field, gradients)[field.index(51, 100)], cosine * cosine,
                0.02)
        << slope;
  }
}

TEST(SkyView, IsTheSameForAnyNumberOfThreads) {
  const HeightField field = with_holes(fractal(50, 44, 400.0, 4), 0.05, 4);
  const auto gradients = surface_gradients(field, SurfaceEstimator::sobel);
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const auto level = sky_view_factors(field, {.azimuths = 13});
  const auto tilted = tilted_sky_view_factors(field, gradients, {.azimuths = 13});
  for (std::size_t i = 0; i < level.size(); ++i) {
    EXPECT_EQ(std::isnan(level[i]), std::isnan(field.heights()[i]));
    if (!std::isnan(level[i])) {
      EXPECT_GT(level[i], 0.0);
      EXPECT_LE(level[i], 1.0);
      EXPECT_GT(tilted[i], 0.0);
      EXPECT_LE(tilted[i], 1.0 + 1e-12);
    }
  }
  for (const int threads : {2, 4, 8, 40}) {
    EXPECT_TRUE(std::ranges::equal(sky_view_factors(field, {.azimuths = 13, .threads = threads}),
                                   level, same));
    EXPECT_TRUE(std::ranges::equal(
        tilted_sky_view_factors(field, gradients, {.azimuths = 13, .threads = threads}), tilted,
        same));
  }
}

TEST(SkyView, RefusesWhatItCannotUse) {
  const HeightField field(3, 3, 1.0, 1.0);
  EXPECT_THROW(sky_view_factors(field, {.azimuths = 0}), ContractViolation);
  EXPECT_THROW(tilted_sky_view_factors(field, std::vector<SurfaceGradient>(8)), ContractViolation);
}

}  // namespace
}  // namespace phytobench
