// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_rays.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_noise.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::oracles::lesser2019 {
namespace {

constexpr double radians_per_degree = 3.14159265358979323846 / 180;

bool is_level(const Direction& sun) {
  return sun.u == 0 && sun.v == 0;
}

/// An endless slope that rises towards an azimuth.
Heights ramp(double slope, double azimuth) {
  Heights map = flat(41, 16);
  const double rise = std::tan(slope * radians_per_degree);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i)
      map.at(i, j) =
          16 * rise *
          (i * std::cos(azimuth * radians_per_degree) + j * std::sin(azimuth * radians_per_degree));
  return map;
}

/// It hides the sun if its rise towards the sun is steeper than the sun is high, and only then.
TEST(LesserRayOracle, SurfaceIsExactOnSlopes) {
  for (const double towards : {0.0, 30.0, 75.0})
    for (const double azimuth : {0.0, 15.0, 30.0, 45.0, 75.0})
      for (const double slope : {10.0, 20.0, 29.0, 31.0, 40.0}) {
        const double rise = std::tan(slope * radians_per_degree) *
                            std::cos((azimuth - towards) * radians_per_degree);
        const Ray found =
            ray(ramp(slope, towards), 5, 5, equation_8_1({30, azimuth}), Reading::surface);
        EXPECT_EQ(found.lit, rise < std::tan(30 * radians_per_degree))
            << slope << " " << azimuth << " " << towards;
        EXPECT_EQ(found.lit, found.margin >= 0);
      }
}

/// The first column begins half a pixel on and stands a whole one higher; and what stands beside
/// the ray is not on it.
TEST(LesserRayOracle, ColumnsAreDarkOnSlopesThatAreLit) {
  EXPECT_FALSE(ray(ramp(20, 0), 5, 5, equation_8_1({30, 0}), Reading::entry).lit);
  EXPECT_TRUE(ray(ramp(16, 0), 5, 5, equation_8_1({30, 0}), Reading::entry).lit);
  EXPECT_TRUE(ray(ramp(29, 0), 5, 5, equation_8_1({30, 0}), Reading::foot).lit);
  EXPECT_FALSE(ray(ramp(29, 0), 5, 5, equation_8_1({30, 30}), Reading::foot).lit);
  EXPECT_TRUE(ray(ramp(29, 0), 5, 5, equation_8_1({30, 30}), Reading::surface).lit);
}

int shadow_pixels(double elevation, Reading reading) {
  Heights map = flat(60, 16);
  for (int j = 0; j < 60; ++j) map.at(50, j) = 100;
  int dark = 0;
  for (int i = 0; i < 50; ++i) dark += !ray(map, i, 30, equation_8_1({elevation, 0}), reading).lit;
  return dark;
}

/// Behind a wall of 100 m, the shadow's length being 100 m / tan(elevation).
TEST(LesserRayOracle, ShadowsAreAsLongAsTheyMustBe) {
  const std::array<std::array<int, 4>, 3> pixels = {
      {{30, 10, 10, 11}, {15, 23, 23, 23}, {45, 6, 6, 6}}};
  for (const auto& [elevation, surface, foot, entry] : pixels) {
    EXPECT_EQ(shadow_pixels(elevation, Reading::surface), surface) << elevation;
    EXPECT_EQ(shadow_pixels(elevation, Reading::foot), foot) << elevation;
    EXPECT_EQ(shadow_pixels(elevation, Reading::entry), entry) << elevation;
  }
}

struct RidgeHours {
  int north = 0, south = 0, north_by_march = 0;
};
RidgeHours hours_on_ridge(double slope, double M) {
  Heights map = flat(33, 16);
  for (int j = 0; j < 33; ++j)
    for (int i = 0; i < 33; ++i)
      map.at(i, j) = (16 - std::abs(j - 16)) * 16 * std::tan(slope * radians_per_degree);
  RidgeHours hours;
  for (const Direction& sun : directions({.M = M})) {
    hours.north += is_level(sun) || ray(map, 16, 8, sun, Reading::surface).lit;
    hours.south += is_level(sun) || ray(map, 16, 24, sun, Reading::surface).lit;
    hours.north_by_march += PrintedMarch(map).from(16, 8, sun).outcome == Outcome::lit;
  }
  return hours;
}

/// The profile angle of the printed path is never below 45 degrees with M = 90.
TEST(LesserRayOracle, ARidgeFromEastToWestDarkensOnlySteepFlanks) {
  const std::array<std::array<int, 3>, 10> expected = {{{90, 30, 13},
                                                        {90, 40, 13},
                                                        {90, 44, 13},
                                                        {90, 48, 11},
                                                        {90, 55, 7},
                                                        {80, 30, 13},
                                                        {80, 40, 13},
                                                        {80, 44, 11},
                                                        {80, 48, 9},
                                                        {80, 55, 7}}};
  for (const auto& [M, slope, north] : expected) {
    const RidgeHours hours = hours_on_ridge(slope, M);
    EXPECT_EQ(hours.north, north) << M << " " << slope;
    EXPECT_EQ(hours.north_by_march, north) << M << " " << slope;
    EXPECT_EQ(hours.south, 13) << M << " " << slope;
  }
}

struct NoiseCounts {
  std::array<int, 3> lit{};      ///< surface, foot, entry
  std::array<int, 3> differs{};  ///< of the printed march from each
};
NoiseCounts counts_on_noise(const Heights& map) {
  NoiseCounts counts;
  const PrintedMarch march(map);
  for (const Direction& sun : directions({}))
    for (int y = 0; y < map.n_y; ++y)
      for (int x = 0; x < map.n_x; ++x) {
        const bool printed = march.from(x, y, sun).outcome == Outcome::lit;
        for (const Reading reading : {Reading::surface, Reading::foot, Reading::entry}) {
          const auto k = static_cast<std::size_t>(reading == Reading::surface ? 0
                                                  : reading == Reading::foot  ? 1
                                                                              : 2);
          const bool is_lit = is_level(sun) || ray(map, x, y, sun, reading).lit;
          counts.lit[k] += is_lit;
          counts.differs[k] += is_lit != printed;
        }
      }
  return counts;
}

/// As a literal program in Python counts them.
TEST(LesserRayOracle, ReadingsDifferOnNoise) {
  const NoiseCounts one = counts_on_noise(value_noise(64, 1, 400, 16));
  EXPECT_EQ(one.lit, (std::array<int, 3>{35468, 33823, 31035}));
  EXPECT_EQ(one.differs[1], 1487);
  EXPECT_EQ(one.differs[2], 4131);
  EXPECT_NEAR(100.0 * one.differs[0] / 53248, 2.40, 0.005);
  const NoiseCounts two = counts_on_noise(value_noise(64, 2, 400, 16));
  EXPECT_EQ(two.lit, (std::array<int, 3>{36580, 34818, 31687}));
  EXPECT_EQ(two.differs[1], 1630);
  EXPECT_EQ(two.differs[2], 4651);
  EXPECT_NEAR(100.0 * two.differs[0] / 53248, 2.63, 0.005);
}

TEST(LesserRayOracle, AMirrorImageHasTheMirroredShadows) {
  const Heights map = mirror_symmetric(value_noise(32, 3, 400, 16));
  for (const Reading reading : {Reading::surface, Reading::foot, Reading::entry})
    for (const Direction& sun : directions({})) {
      if (is_level(sun)) continue;
      const Direction mirrored{-sun.u, sun.v, sun.w};
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          ASSERT_EQ(ray(map, x, y, sun, reading).lit, ray(map, 31 - x, y, mirrored, reading).lit);
    }
}

TEST(LesserRayOracle, TheMarginSaysHowFarARayPasses) {
  Heights map = flat(16, 16);
  map.at(8, 4) = 40;
  const Direction sun{0.8, 0, 0.6};
  EXPECT_NEAR(ray(map, 4, 4, sun, Reading::surface).margin, 64 * 0.75 - 40, 1e-12);
  map.at(8, 4) = 50;
  EXPECT_NEAR(ray(map, 4, 4, sun, Reading::surface).margin, -2, 1e-12);
  EXPECT_FALSE(ray(map, 4, 4, sun, Reading::surface).lit);
  EXPECT_EQ(ray(map, 15, 4, sun, Reading::surface).compared, 0);
  map.at(8, 4) = std::nan("");
  EXPECT_TRUE(ray(map, 4, 4, sun, Reading::surface).lit) << "what is not known hides nothing";
}

}  // namespace
}  // namespace phytobench::oracles::lesser2019
