// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_march.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reference/oracles/lesser2019_noise.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::oracles::lesser2019 {
namespace {

/// The direction of an hour (from 1) of the path with 13 hours.
Direction sun_of_hour(int hour, double M = 90) {
  return directions({.M = M})[static_cast<std::size_t>(hour - 1)];
}

/// Rays over flat ground, with the terrain just higher than they are: nothing ends them but the
/// border.
struct Ends {
  int stuck = 0, crashed = 0;
  bool operator==(const Ends&) const = default;
};
Ends ends_over_flat_ground(double ps, int hour, MarchForm form = {}) {
  const Heights ground = flat(64, ps);
  const PrintedMarch march(ground, form);
  Direction sun = sun_of_hour(hour);
  sun.w = 0;
  Ends ends;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const Outcome outcome = march.over(x, y, 0, sun, 1).outcome;
      ends.stuck += outcome == Outcome::stuck;
      ends.crashed += outcome == Outcome::crashed;
    }
  return ends;
}

TEST(LesserMarchOracle, VisitsWhatTheListingVisits) {
  Heights map = flat(16, 16);
  map.at(6, 4) = 1000;
  const MarchResult result = PrintedMarch(map).from(4, 4, sun_of_hour(2));
  EXPECT_EQ(result.outcome, Outcome::lit) << "the ray passes through pixel (6, 4)";
  std::vector<std::pair<int, int>> pixels;
  for (const Visited& one : result.visited) pixels.emplace_back(one.i, one.j);
  EXPECT_EQ(pixels,
            (std::vector<std::pair<int, int>>{{5, 4}, {7, 5}, {8, 5}, {11, 6}, {12, 6}, {15, 7}}));
  EXPECT_NEAR(result.visited[0].Y, 68.28724544480171, 1e-12);
  EXPECT_EQ(PrintedMarch(map, {.larger_remainder = false}).from(4, 4, sun_of_hour(2)).outcome,
            Outcome::dark);
}

TEST(LesserMarchOracle, TheZenithAndFlatGroundAreLit) {
  Heights map = flat(16, 16);
  EXPECT_EQ(PrintedMarch(map).from(3, 3, {1, 0, 0}).iterations, 0);
  map.at(0, 0) = 50;
  EXPECT_EQ(PrintedMarch(map).from(3, 3, {0, 0, 1}).outcome, Outcome::lit);
  EXPECT_EQ(PrintedMarch(map).from(3, 0, {-1, 0, 0}).outcome, Outcome::dark);
}

TEST(LesserMarchOracle, CrashesFromACentreInTheFirstHour) {
  Heights map = flat(16, 16);
  map.at(0, 0) = 50;
  EXPECT_EQ(PrintedMarch(map, {.start = Start::centre}).from(0, 1, {1, 0, 0}).outcome,
            Outcome::crashed);
  EXPECT_EQ(
      PrintedMarch(map, {.unguarded = false, .start = Start::centre}).from(0, 1, {1, 0, 0}).outcome,
      Outcome::lit);
}

/// As a literal program in Python counts them.
TEST(LesserMarchOracle, IsStuckAndCrashesWherePixelSizesAreRounded) {
  const std::array<Ends, 13> at_0_1 = {{{444, 3303},
                                        {2206, 0},
                                        {2500, 0},
                                        {2957, 0},
                                        {2653, 0},
                                        {2309, 0},
                                        {0, 0},
                                        {1924, 0},
                                        {2066, 0},
                                        {2986, 0},
                                        {1781, 0},
                                        {1397, 0},
                                        {0, 2345}}};
  const std::array<Ends, 13> at_7_3 = {{{832, 3093},
                                        {2834, 0},
                                        {3266, 0},
                                        {3468, 0},
                                        {3299, 0},
                                        {2966, 0},
                                        {0, 0},
                                        {2718, 0},
                                        {2662, 0},
                                        {3382, 0},
                                        {2890, 0},
                                        {2115, 0},
                                        {0, 2517}}};
  for (int hour = 1; hour <= 13; ++hour) {
    const auto k = static_cast<std::size_t>(hour - 1);
    EXPECT_EQ(ends_over_flat_ground(0.1, hour), at_0_1[k]) << hour;
    EXPECT_EQ(ends_over_flat_ground(7.3, hour), at_7_3[k]) << hour;
    EXPECT_EQ(ends_over_flat_ground(0.1, hour, {.unguarded = false}), Ends{}) << hour;
    EXPECT_EQ(ends_over_flat_ground(7.3, hour, {.unguarded = false}), Ends{}) << hour;
  }
}

TEST(LesserMarchOracle, EndsWherePixelSizesAreExact) {
  for (const double ps : {1.0, 15.625, 16.0, 90.0})
    for (int hour = 1; hour <= 13; ++hour)
      EXPECT_EQ(ends_over_flat_ground(ps, hour), Ends{}) << ps << " hour " << hour;
}

TEST(LesserMarchOracle, TakesWhatIsLessThanAPixelOutsideForInside) {
  const Heights ground = flat(32, 16);
  int outside = 0, all = 0, outside_with_floor = 0;
  for (int hour = 8; hour <= 13; ++hour) {
    Direction sun = sun_of_hour(hour);
    sun.w = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        for (const Visited& one : PrintedMarch(ground).over(x, y, 0, sun, 1).visited) {
          ++all;
          outside += one.X < 0 || one.Y < 0;
        }
        for (const Visited& one :
             PrintedMarch(ground, {.truncates = false}).over(x, y, 0, sun, 1).visited)
          outside_with_floor += one.X < 0 || one.Y < 0;
      }
  }
  EXPECT_EQ(all, 97626);
  EXPECT_EQ(outside, 1515);
  EXPECT_EQ(outside_with_floor, 0);
}

TEST(LesserMarchOracle, NeedsACubeOfStepsForASquareOfPixels) {
  for (const int n : {16, 32, 64}) {
    Heights map = flat(n, 16);
    map.at(0, 0) = 1;
    long iterations = 0;
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) iterations += PrintedMarch(map).from(x, y, {1, 0, 0}).iterations;
    EXPECT_EQ(iterations, static_cast<long>(n) * n * (n + 1) / 2 - n);
  }
}

/// Found by walking along the rays in steps of 5 cm; from the corner to the south-west no cell's
/// inside is met where the listing looks.
TEST(LesserMarchOracle, PassesOverCells) {
  const Heights ground = flat(64, 16);
  const std::array<double, 13> untested_percent = {0,    56.6, 25.2, 0,    27.7, 58.0, 0,
                                                   42.6, 35.0, 0,    39.5, 54.3, 0};
  for (int hour = 1; hour <= 13; ++hour) {
    if (hour == 7 || hour == 10) continue;
    Untested sum;
    for (const auto& [x, y] :
         std::vector<std::pair<int, int>>{{2, 3}, {10, 5}, {30, 20}, {33, 2}, {60, 7}, {50, 40}}) {
      const Untested one = untested_cells(ground, x, y, sun_of_hour(hour));
      sum.crossed += one.crossed;
      sum.untested += one.untested;
    }
    EXPECT_NEAR(100.0 * sum.untested / sum.crossed,
                untested_percent[static_cast<std::size_t>(hour - 1)], 0.05)
        << hour;
  }
}

struct LitPixels {
  int all = 0;
  std::vector<int> hours;  ///< of each pixel
};
LitPixels lit_by_march(const Heights& map, MarchForm form = {}) {
  LitPixels lit;
  lit.hours.assign(map.h.size(), 0);
  const PrintedMarch march(map, form);
  for (const Direction& sun : directions({}))
    for (int y = 0; y < map.n_y; ++y)
      for (int x = 0; x < map.n_x; ++x) {
        const bool is_lit = march.from(x, y, sun).outcome == Outcome::lit;
        lit.all += is_lit;
        lit.hours[map.index(x, y)] += is_lit;
      }
  return lit;
}

TEST(LesserMarchOracle, CountsOnNoiseAsALiteralProgramDoes) {
  const Heights one = value_noise(64, 1, 400, 16), two = value_noise(64, 2, 400, 16);
  EXPECT_EQ(lit_by_march(one).all, 35128);
  EXPECT_EQ(lit_by_march(one, {.truncates = false}).all, 35141);
  EXPECT_EQ(lit_by_march(two).all, 36306);
  EXPECT_EQ(lit_by_march(two, {.truncates = false}).all, 36316);
}

TEST(LesserMarchOracle, LosesTheMirrorSymmetryOfItsTerrain) {
  const Heights map = mirror_symmetric(value_noise(64, 1, 400, 16));
  const LitPixels lit = lit_by_march(map);
  int pixels = 0, most = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const int apart = std::abs(lit.hours[map.index(x, y)] - lit.hours[map.index(63 - x, y)]);
      pixels += apart > 0;
      most = std::max(most, apart);
    }
  EXPECT_EQ(pixels, 678);
  EXPECT_EQ(most, 2);
}

}  // namespace
}  // namespace phytobench::oracles::lesser2019
