// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_sun.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench::oracles::lesser2019 {
namespace {

using testing::ElementsAre;

std::vector<double> elevations(const Day& day) {
  std::vector<double> all;
  for (const Angles& sun : path(day)) all.push_back(std::round(sun.elevation * 1000) / 1000);
  return all;
}

TEST(LesserSunOracle, ThirteenHours) {
  const std::array<std::array<double, 5>, 7> morning = {{{0, 0, 1, 0, 0},
                                                         {15, 15, .933, .25, .2588},
                                                         {30, 30, .75, .433, .5},
                                                         {45, 45, .5, .5, .7071},
                                                         {60, 60, .25, .433, .866},
                                                         {75, 75, .067, .25, .9659},
                                                         {90, 90, 0, 0, 1}}};
  const std::vector<Angles> angles = path({});
  const std::vector<Direction> suns = directions({});
  ASSERT_EQ(angles.size(), 13u);
  for (std::size_t k = 0; k < 13; ++k) {
    const bool is_evening = k > 6;
    const auto& [azimuth, elevation, u, v, w] = morning[is_evening ? 12 - k : k];
    EXPECT_EQ(angles[k].elevation, elevation);
    EXPECT_EQ(angles[k].azimuth, is_evening ? 180 - azimuth : azimuth);
    EXPECT_EQ(suns[k].u, is_evening ? -u : u) << k;
    EXPECT_EQ(suns[k].v, v) << k;
    EXPECT_EQ(suns[k].w, w) << k;
  }
}

TEST(LesserSunOracle, EvenHoursByEveryReading) {
  EXPECT_THAT(elevations({.H = 4}), ElementsAre(0, 45, 90, 45));
  EXPECT_THAT(elevations({.H = 4, .loop = Loop::level_noon}), ElementsAre(0, 45, 45, 0));
  EXPECT_THAT(elevations({.H = 4, .elevation = ElevationStep::one_formula}),
              ElementsAre(0, 90, 90, 0));
  EXPECT_THAT(elevations({.H = 4, .elevation = ElevationStep::tent}), ElementsAre(0, 60, 60, 0));
  EXPECT_THAT(elevations({.H = 12}), ElementsAre(0, 15, 30, 45, 60, 75, 90, 75, 60, 45, 30, 15));
  EXPECT_THAT(elevations({.H = 12, .elevation = ElevationStep::one_formula}),
              ElementsAre(0, 18, 36, 54, 72, 90, 90, 72, 54, 36, 18, 0));
  EXPECT_THAT(elevations({.H = 12, .elevation = ElevationStep::tent}),
              ElementsAre(0, 16.364, 32.727, 49.091, 65.455, 81.818, 81.818, 65.455, 49.091, 32.727,
                          16.364, 0));
}

TEST(LesserSunOracle, ShortDays) {
  EXPECT_THAT(elevations({.H = 1, .s0 = 7}), ElementsAre(7));
  EXPECT_THAT(elevations({.H = 2}), ElementsAre(0, 90));
  EXPECT_THAT(elevations({.H = 2, .s0 = 3, .elevation = ElevationStep::one_formula}),
              ElementsAre(3, 3));
  EXPECT_THAT(elevations({.H = 3}), ElementsAre(0, 90, 0));
  EXPECT_EQ(path({.H = 2, .a0 = 20}).back().azimuth, 160);
  EXPECT_EQ(path({.H = 3, .a0 = 20}).back().azimuth, 200);
  EXPECT_EQ(path({.H = 2, .a0 = 120}).back().azimuth, 60) << "the sun runs backwards";
  EXPECT_EQ(path({.H = 2, .a0 = 20, .azimuth = AzimuthStep::always_half}).back().azimuth, 200);
}

TEST(LesserSunOracle, OnlyOddHoursReturnAsPrinted) {
  int returning = 0;
  for (int H = 3; H <= 24; ++H) {
    const bool returns = std::abs(path({.H = H}).back().elevation) < 1e-9;
    EXPECT_EQ(returns, H % 2 == 1) << H;
    returning += returns;
    for (const ElevationStep step : {ElevationStep::one_formula, ElevationStep::tent})
      EXPECT_NEAR(path({.H = H, .elevation = step}).back().elevation, 0, 1e-9) << H;
  }
  EXPECT_EQ(returning, 11);
}

TEST(LesserSunOracle, TheStepOfTheTextMissesTheZenith) {
  EXPECT_NEAR(elevation_per_hour({.elevation = ElevationStep::text}), 13.846153846153847, 1e-12);
  EXPECT_NEAR(path({.elevation = ElevationStep::text})[6].elevation, 83.07692307692308, 1e-12);
  EXPECT_NEAR(elevation_per_hour({.M = 80}), 80.0 / 6, 1e-12);
}

TEST(LesserSunOracle, RoundsAsPythonDoes) {
  EXPECT_EQ(rounded_to_four(0.25881904510252074), 0.2588);
  EXPECT_EQ(rounded_to_four(0.00005), 0.0001) << "a little more than a half in binary";
  EXPECT_EQ(rounded_to_four(0.00015), 0.0001) << "a little less";
  EXPECT_EQ(rounded_to_four(0.03125), 0.0312) << "a half exactly: to even";
  EXPECT_EQ(rounded_to_four(6e-17), 0.0);
  double worst = 0;
  for (int el = 0; el <= 900; el += 3)
    for (int az = 0; az <= 180; ++az) {
      const Direction d = listing_9_7({el / 10.0, static_cast<double>(az)});
      worst = std::max(worst, std::abs(std::sqrt(d.u * d.u + d.v * d.v + d.w * d.w) - 1));
    }
  EXPECT_LE(worst, std::sqrt(3) * 5e-5);
  EXPECT_GT(worst, 7e-5);
}

/// The printed path is the curve of Viviani, which no sun follows.
TEST(LesserSunOracle, IsVivianisCurve) {
  double exact = 0, rounded = 0;
  for (const Angles& sun : path({})) {
    const Direction d = equation_8_1(sun), r = listing_9_7(sun);
    exact = std::max(exact, std::abs(d.u * d.u + d.v * d.v - std::abs(d.u)));
    rounded = std::max(rounded, std::abs(r.u * r.u + r.v * r.v - std::abs(r.u)));
  }
  EXPECT_LE(exact, 1e-15);
  EXPECT_NEAR(rounded, 1.1e-5, 1e-9);
}

TEST(LesserSunOracle, TheTrueSun) {
  EXPECT_NEAR(true_sun(0, 0, -45).elevation, 45, 1e-12);
  EXPECT_NEAR(true_sun(0, 0, -45).azimuth, 0, 1e-12);
  EXPECT_NEAR(true_sun(47.52, 23.44, 0).elevation, 65.92, 1e-9);
  EXPECT_NEAR(true_sun(47.52, 0, -90).azimuth, 0, 1e-9) << "rises due east";
  EXPECT_NEAR(std::tan(true_sun(47.52, 0, -45).azimuth * 3.14159265358979323846 / 180),
              std::sin(47.52 * 3.14159265358979323846 / 180), 1e-12);
  EXPECT_EQ(true_noon_elevation(0, 23.44), 66.56);
  EXPECT_NEAR(top_of_atmosphere(0, 0, 1361), 8946.029359537864, 1e-8);
  EXPECT_NEAR(top_of_atmosphere(47.52, 0, 1361), 6041.547128909836, 1e-8);
  EXPECT_NEAR(top_of_atmosphere(-89.999, -23.44, 1361 * 1.0344), 11564.342224342652, 1e-6);
}

}  // namespace
}  // namespace phytobench::oracles::lesser2019
