// SPDX-License-Identifier: MIT
// The stages after the shadows: energy, reflection, relief, soil, water, chances, images.
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/oracles/lesser2019_noise.hpp"
#include "reference/oracles/lesser2019_relief.hpp"

namespace phytobench::oracles::lesser2019 {
namespace {

constexpr Losses polar_zone{40, 45, 8};

TEST(LesserEnergyOracle, ADayOnDirtInThePolarZone) {
  EXPECT_EQ(SOLAR_CONSTANT_K_CALORIES_PER_HOUR, 1200);
  EXPECT_EQ(raw_energy_of_flat_ground({}), 15600);
  EXPECT_NEAR(raw_energy_by_height({}), 9114.90493527018, 1e-9);
  EXPECT_NEAR(raw_energy_by_height({.M = 80}), 8483.870008250073, 1e-9);
  EXPECT_EQ(through_the_air(15600, polar_zone), 1092);
  EXPECT_EQ(listing_9_13(15600, polar_zone, 0.25), 819);
  EXPECT_NEAR(listing_9_13(15600, {0.40, 0.45, 0.08}, 0.25), 11591.19, 1e-9);
  EXPECT_NEAR(listing_9_13(15600, {45, 8, 50}, 0.25), -351, 1e-9);
}

TEST(LesserReflectionOracle, FlatGroundWithEveryPadding) {
  const Values even = even_values(5, 819);
  const Values zeros = listing_9_14(even, 0.1);
  EXPECT_NEAR(zeros.at(2, 2), 900.9, 1e-12);
  EXPECT_NEAR(zeros.at(0, 2), 870.1875, 1e-12);
  EXPECT_NEAR(zeros.at(4, 4), 849.7125, 1e-12);
  for (const Values& whole :
       {listing_9_14(even, 0.1, Padding::edge),
        listing_9_14(even, 0.1, Padding::zeros, Divisor::number_of_neighbours)})
    for (const double value : whole.value) EXPECT_NEAR(value, 900.9, 1e-12);
}

TEST(LesserReflectionOracle, EachNeighbourGivesOnce) {
  for (int k = 0; k < 9; ++k) {
    Values unit = even_values(3, 0);
    unit.value[static_cast<std::size_t>(k)] = 8;
    EXPECT_EQ(listing_9_14(unit, 1).at(1, 1), k == 4 ? 8 : 1);
  }
}

TEST(LesserReflectionOracle, ByAlbedo) {
  const auto middle = [](double incident, double albedo, Received received) {
    return reflected_by_albedo(even_values(3, incident), even_values(3, albedo), 0.1, received)
        .at(1, 1);
  };
  EXPECT_NEAR(middle(1092, 0.25, Received::partly_reflected_again), 839.475, 1e-12);
  EXPECT_NEAR(middle(1092, 0.25, Received::all), 846.3, 1e-12);
  EXPECT_EQ(middle(1000, 0, Received::all), 1000);
  EXPECT_NEAR(middle(1000, 0.84, Received::partly_reflected_again), 173.44, 1e-12);
  EXPECT_NEAR(middle(1000, 0.84, Received::all), 244, 1e-12);
  EXPECT_NEAR(listing_9_14(even_values(3, 1000), 0.1).at(1, 1), 1100, 1e-12) << "out of nothing";
}

TEST(LesserReflectionOracle, WhatIsNotKnownGivesNothing) {
  Values hole = even_values(3, 819);
  hole.value[0] = std::nan("");
  EXPECT_NEAR(listing_9_14(hole, 0.1).at(1, 1), 819 + 0.1 * 819 * 7 / 8, 1e-12);
  EXPECT_NEAR(listing_9_14(hole, 0.1, Padding::zeros, Divisor::number_of_neighbours).at(1, 1),
              900.9, 1e-12);
  EXPECT_TRUE(std::isnan(listing_9_14(hole, 0.1).at(0, 0)));
}

/// Heights of a function of columns and rows around (2, 2).
Heights around_two(double ps, const std::function<double(int, int)>& height) {
  Heights map = flat(5, ps);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) map.at(i, j) = height(i - 2, j - 2);
  return map;
}

/// Area, both diagonals, then unit weights, both diagonals, then Sobel.
std::array<double, 5> five_slopes(const Heights& map) {
  constexpr Diagonal sw_ne = Diagonal::south_west_north_east;
  constexpr Diagonal nw_se = Diagonal::north_west_south_east;
  return {angle_to_vertical(normal_of_six_faces(map, 2, 2, sw_ne, FaceWeight::area)),
          angle_to_vertical(normal_of_six_faces(map, 2, 2, nw_se, FaceWeight::area)),
          angle_to_vertical(normal_of_six_faces(map, 2, 2, sw_ne, FaceWeight::unit)),
          angle_to_vertical(normal_of_six_faces(map, 2, 2, nw_se, FaceWeight::unit)),
          angle_to_vertical(sobel_corrected(map, 2, 2))};
}

TEST(LesserReliefOracle, PlanesHaveTheirSlope) {
  const auto plane = [](double a, double b) {
    return around_two(16, [a, b](int i, int j) { return 16 * (a * i + b * j); });
  };
  for (const double slope : five_slopes(plane(1, 0))) EXPECT_NEAR(slope, 45, 1e-10);
  for (const double slope : five_slopes(plane(0, std::sqrt(3)))) EXPECT_NEAR(slope, 60, 1e-10);
  for (const double slope : five_slopes(plane(0.3, -0.7)))
    EXPECT_NEAR(slope, 37.29207573526101, 1e-10);
  const Normal n = normal_of_six_faces(plane(0.3, -0.7), 2, 2),
               s = sobel_corrected(plane(0.3, -0.7), 2, 2);
  EXPECT_NEAR(n.x / n.z, -0.3, 1e-12);
  EXPECT_NEAR(n.y / n.z, 0.7, 1e-12);
  EXPECT_NEAR(s.x / s.z, -0.3, 1e-12);
  EXPECT_NEAR(s.y / s.z, 0.7, 1e-12);
  // Three, two and one face at the border.
  for (const auto& [i, j] : {std::array{0, 2}, {4, 0}, {0, 0}, {0, 4}, {4, 4}})
    EXPECT_NEAR(angle_to_vertical(normal_of_six_faces(plane(0.3, -0.7), i, j)), 37.29207573526101,
                1e-10);
}

TEST(LesserReliefOracle, CreasesCliffsAndNeedles) {
  const auto crease = five_slopes(around_two(16, [](int i, int) { return 16.0 * std::max(i, 0); }));
  const auto cliff = five_slopes(around_two(16, [](int i, int) { return i > 0 ? 160.0 : 0.0; }));
  for (const std::size_t k : {0u, 1u, 4u}) {
    EXPECT_NEAR(crease[k], 26.56505117707799, 1e-10);
    EXPECT_NEAR(cliff[k], 78.69006752597979, 1e-10);
  }
  for (const std::size_t k : {2u, 3u}) {
    EXPECT_NEAR(crease[k], 22.5, 1e-10);
    EXPECT_NEAR(cliff[k], 42.144703431250186, 1e-10);
  }
  const Heights needle = around_two(16, [](int i, int j) { return i == 0 && j == 0 ? 1000. : 0.; });
  for (const double slope : five_slopes(needle)) EXPECT_NEAR(slope, 0, 1e-6);
  EXPECT_NEAR(steepest_edge(needle, 2, 2), 89.0833457, 1e-7);
}

/// Gradients by area as closed forms, which the vertex itself is not in; N is j - 1 here.
TEST(LesserReliefOracle, AreaWeightsHaveAClosedForm) {
  const Heights map = value_noise(8, 5, 50, 16);
  const auto h = [&](int i, int j) { return map.at(3 + i, 3 + j); };
  const double gx = (2 * (h(1, 0) - h(-1, 0)) + h(1, -1) - h(0, -1) + h(0, 1) - h(-1, 1)) / 96;
  const double gy = (2 * (h(0, 1) - h(0, -1)) + h(1, 0) - h(1, -1) + h(-1, 1) - h(-1, 0)) / 96;
  const Normal n = normal_of_six_faces(map, 3, 3);
  EXPECT_NEAR(-n.x / n.z, gx, 1e-14);
  EXPECT_NEAR(-n.y / n.z, gy, 1e-14);
  Heights raised = map;
  raised.at(3, 3) += 1000;
  const Normal other = normal_of_six_faces(raised, 3, 3);
  EXPECT_NEAR(other.x, n.x, 1e-12);
  EXPECT_NEAR(other.y, n.y, 1e-12);
}

/// Errors in degrees at a place of a smooth surface, from halved pixels; rows run as y does.
TEST(LesserReliefOracle, ConvergesWithTheSquareOfThePixelSize) {
  const auto f = [](double x, double y) {
    return std::sin(x) * std::cos(y) + .1 * x * x * x + .05 * x * x * y;
  };
  const double truth = std::atan(std::hypot(std::cos(.7) * std::cos(.4) + .3 * .49 + .1 * .7 * .4,
                                            -std::sin(.7) * std::sin(.4) + .05 * .49)) *
                       180 / 3.14159265358979323846;
  // Against the frame of the closed forms, whose north is +y, the diagonals change places.
  const std::array<std::array<double, 5>, 2> errors = {
      {{-.3012432626, -.0865942736, -.3052381822, -.1001050442, -.2743308586},
       {-.0756935604, -.0218184409, -.0764713383, -.0253268551, -.0688871988}}};
  for (std::size_t k = 0; k < 2; ++k) {
    const double e = k == 0 ? .2 : .1;
    const auto slopes =
        five_slopes(around_two(e, [&](int i, int j) { return f(.7 + i * e, .4 + j * e); }));
    for (std::size_t m = 0; m < 5; ++m) EXPECT_NEAR(slopes[m] - truth, errors[k][m], 1e-8) << m;
  }
}

TEST(LesserReliefOracle, SobelAsPrintedIsTooSteepAndTurnsTheNorthSouth) {
  const Heights map = around_two(16, [](int, int j) { return 16.0 * j; });
  EXPECT_EQ(equation_8_3(map, 2, 2).S_y, -128);
  EXPECT_EQ(equation_8_3(map, 2, 2).S_x, 0);
  EXPECT_NEAR(angle_to_vertical(sobel_as_printed(map, 2, 2)), 89.5524, 1e-4);
  EXPECT_GT(sobel_as_printed(map, 2, 2).y, 0) << "it rises to the south and should face north";
  EXPECT_LT(sobel_corrected(map, 2, 2).y, 0);
}

TEST(LesserSoilOracle, DepthByAngleAndByDotProduct) {
  EXPECT_EQ(listing_9_15(0, 150), 150);
  EXPECT_EQ(listing_9_15(45, 150), 75);
  EXPECT_NEAR(listing_9_15(60, 150), 50, 1e-12);
  EXPECT_EQ(listing_9_15(90, 150), 0);
  EXPECT_NEAR(listing_9_15(dot_with_vertical({0, 0, 1}), 150), 148.33333333333333, 1e-12);
  EXPECT_EQ(listing_9_15(dot_with_vertical({1, 0, 0}), 150), 150);
}

constexpr Ground polar_dirt{150, 0.38, 1.0, 1.5};

TEST(LesserWaterOracle, WhatIsLeftOnDirtInThePolarZone) {
  EXPECT_NEAR(water_supply(polar_dirt), 0.95, 1e-12);
  EXPECT_NEAR(water_supply({50, 0.38, 1.0, 1.5}), 0.475, 1e-12);
  EXPECT_NEAR(listing_9_16(polar_dirt, 819), 0.50774, 1e-12);
  EXPECT_NEAR(listing_9_16(polar_dirt, 900.9), 0.463514, 1e-12);
  EXPECT_EQ(listing_9_16(polar_dirt, 819, PRINTED_KCAL_PER_ML, Evaporation::divided), 0);
  EXPECT_NEAR(kcal_per_ml(2.5e3, 2.39e-4), 0.5975, 1e-12);
  EXPECT_NEAR(evaporated_litres(819, 0.54, Evaporation::divided), 1.5166666666666666, 1e-12);
  EXPECT_NEAR(evaporated_litres(819, 0.5975, Evaporation::divided), 1.3707112970711295, 1e-12);
  EXPECT_NEAR(listing_9_16(polar_dirt, 900.9, 0.5975), 0.411712, 1e-6) << "E01 alone";
  EXPECT_EQ(listing_9_16(polar_dirt, 1e6), 0) << "never below nothing";
}

TEST(LesserChanceOracle, TriangleAndDepthRules) {
  EXPECT_EQ(listing_9_17(2000, 0), 0);
  EXPECT_EQ(listing_9_17(2000, 2000), 1);
  EXPECT_EQ(listing_9_17(2000, 4000), 0);
  EXPECT_EQ(listing_9_17(2000, 5000), 0);
  EXPECT_EQ(listing_9_17(2000, 3000), 0.5);
  EXPECT_EQ(listing_9_17(2000, 819), 0.4095);
  EXPECT_TRUE(std::isnan(listing_9_17(0, 0)));
  EXPECT_EQ(listing_9_17(0, 1), 0);
  EXPECT_EQ(depth_chance(80, 150, DepthRule::triangle), 0.125);
  EXPECT_EQ(depth_chance(80, 150, DepthRule::saturating), 1);
  EXPECT_EQ(depth_chance(80, 40, DepthRule::saturating), 0.5);
  EXPECT_EQ(depth_chance(80, 40, DepthRule::threshold), 0);
  EXPECT_EQ(depth_chance(80, 40, DepthRule::ignored), 1);
  EXPECT_EQ(depth_chance(1, 150, DepthRule::triangle), 0);
}

/// [Lesser2019] with Appletree on flat dirt in the polar zone, from the sun to the chance.
TEST(LesserChanceOracle, TheWorkedExampleAsPrinted) {
  const Values kept = even_values(5, listing_9_13(raw_energy_of_flat_ground({}), polar_zone, 0.25));
  const double energy = listing_9_14(kept, 0.1).at(2, 2);
  const double water = listing_9_16(polar_dirt, energy);
  EXPECT_NEAR(energy, 900.9, 1e-12);
  EXPECT_NEAR(listing_9_17(0.7, water), 0.662162857142857, 1e-12);
  EXPECT_NEAR(least_chance({listing_9_17(2000, energy), listing_9_17(0.7, water),
                            depth_chance(80, 150, DepthRule::saturating), 1}),
              0.45045, 1e-12);
}

TEST(LesserImageOracle, SavingCutsOffAndWraps) {
  EXPECT_EQ(reloaded(0.25), 0.25);
  EXPECT_EQ(reloaded(1.001), 1.0) << "1000.9999999999999";
  EXPECT_EQ(reloaded(150), 18.928);
  EXPECT_EQ(saved_pixel(80), 14464);
  EXPECT_EQ(reloaded_without_wrap(150), 150);
  EXPECT_EQ(reloaded_rounded(1.001), 1.001);
  int changed = 0, changed_again = 0;
  for (int code = 0; code < 65536; ++code) {
    const double once = reloaded(code / 1000.0);
    changed += once != code / 1000.0;
    changed_again += reloaded(once) != once;
  }
  EXPECT_EQ(changed, 741);
  EXPECT_EQ(changed_again, 0);
}

TEST(LesserWaterOracle, ReflectsLittleUnlessTheSunIsLow) {
  EXPECT_NEAR(fresnel(0, 1.333), 0.020373187841971414, 1e-12);
  EXPECT_NEAR(fresnel(60 * 3.14159265358979323846 / 180, 1.333), 0.05969091917515261, 1e-12);
  EXPECT_NEAR(diffuse_fresnel(1.333), 0.0664058, 1e-6);
}

}  // namespace
}  // namespace phytobench::oracles::lesser2019
