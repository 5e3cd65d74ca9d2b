// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/horizon.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/shadow/test_terrains.hpp"

namespace phytobench {
namespace {

using namespace testing_terrains;

constexpr double per_degree = std::numbers::pi / 180.0;
constexpr double earth = 6371000.0;
constexpr double infinitely_low = -std::numeric_limits<double>::infinity();

/// A square wall `reach` cells from the middle, on flat ground.
HeightField square_wall(int reach, double cell, double height) {
  return made(2 * reach + 3, 2 * reach + 3, cell, cell, 0, [&](int column, int row, double) {
    const int away = std::max(std::abs(column - reach - 1), std::abs(row - reach - 1));
    return away == reach ? height : 0.0;
  });
}

double horizon_in_the_middle(const HeightField& field, double azimuth, double radius) {
  const SunDirection heading = direction_of({0.0, azimuth});
  const auto tangents =
      horizon_tangents(field, {heading.east, heading.south}, {.earth_radius = radius});
  const double tangent = tangents[field.index(field.columns() / 2, field.rows() / 2)];
  return std::atan(tangent) / per_degree;
}

/// atan((h - d^2 / 2R) / d), in degrees to six decimals.
TEST(HorizonOracle, WallsStandAsHighAsTheirDistanceAndTheEarthLet) {
  struct Wall {
    double height, distance, flat, curved;
  };
  for (const Wall& wall : {Wall{100, 1000, 5.710593, 5.706141},
                           {100, 10000, 0.572939, 0.527977},
                           {100, 30000, 0.190985, 0.056088},
                           {2000, 100000, 1.145763, 0.696221}}) {
    const HeightField field = square_wall(20, wall.distance / 20, wall.height);
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
      EXPECT_NEAR(horizon_in_the_middle(field, azimuth, 1e300), wall.flat, 0.5e-6);
      EXPECT_NEAR(horizon_in_the_middle(field, azimuth, earth), wall.curved, 0.5e-6);
    }
    // Aslant the straight wall is farther away.
    for (const double aside : {10.0, 27.0, 45.0}) {
      const double farther = wall.distance / std::cos(aside * per_degree);
      // Behind a wall that has sunk out of sight there is the ground next to the place.
      const double curved = std::max((wall.height - farther * farther / (2 * earth)) / farther,
                                     -farther / 20 / (2 * earth));
      for (const double quarter : {0.0, 90.0, 180.0, 270.0})
        EXPECT_NEAR(horizon_in_the_middle(field, quarter + aside, earth),
                    std::atan(curved) / per_degree, 1e-9)
            << wall.distance << ", " << quarter + aside;
    }
  }
}

TEST(HorizonOracle, WallsSinkBelowTheHorizontalBeyondTheRootOf2RH) {
  const double sinks_at = std::sqrt(2 * earth * 100.0);
  EXPECT_NEAR(sinks_at, 35695.94, 0.005);
  for (const double off : {0.99, 1.01}) {
    const HeightField field = square_wall(20, off * sinks_at / 20, 100.0);
    EXPECT_EQ(horizon_in_the_middle(field, 0.0, earth) > 0.0, off < 1.0);
  }
}

/// The slope towards the heading, wherever one looks from.
TEST(HorizonOracle, PlanesRiseAsTheyDo) {
  const HeightField field = made(31, 27, 10.0, 25.0, 0, [](int column, int row, double) {
    return 0.3 * 10.0 * column - 0.2 * 25.0 * row;
  });
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 7.5) {
    const SunDirection to = direction_of({0.0, azimuth});
    const auto tangents = horizon_tangents(field, {5.0 * to.east, 5.0 * to.south});
    for (int row = 2; row < 25; ++row)
      for (int column = 2; column < 29; ++column)
        ASSERT_NEAR(tangents[field.index(column, row)], 0.3 * to.east - 0.2 * to.south, 1e-12)
            << azimuth;
  }
}

/// The steepest rise to any later vertex, where lines meet vertices.
TEST(HorizonOracle, IsTheSteepestRiseAlongColumnsAndDiagonals) {
  for (const double radius : {std::numeric_limits<double>::infinity(), 5e4}) {
    const HeightField field = with_holes(fractal(40, 33, 300.0, 3), 0.1, 3);
    for (const int east : {-1, 0, 1})
      for (const int south : {-1, 0, 1}) {
        if (east == 0 && south == 0) continue;
        const auto tangents =
            horizon_tangents(field, {1.0 * east, 1.0 * south}, {.earth_radius = radius});
        for (int row = 0; row < field.rows(); ++row)
          for (int column = 0; column < field.columns(); ++column) {
            double steepest = infinitely_low;
            for (int k = 1;; ++k) {
              const int c = column + k * east, r = row + k * south;
              if (c < 0 || r < 0 || c >= field.columns() || r >= field.rows()) break;
              if (!field.has_data(c, r)) continue;
              const double distance = 16.0 * k * std::hypot(east, south);
              const double drop = distance * distance / (2 * radius);
              steepest =
                  std::max(steepest, (field.at(c, r) - drop - field.at(column, row)) / distance);
            }
            const double found = tangents[field.index(column, row)];
            if (!field.has_data(column, row))
              EXPECT_FALSE(found > infinitely_low);
            else if (steepest == infinitely_low)
              EXPECT_EQ(found, infinitely_low);
            else
              EXPECT_NEAR(found, steepest, 1e-9);
          }
      }
  }
}

TEST(Horizon, RefusesNoHeading) {
  const HeightField field(3, 3, 1.0, 1.0);
  EXPECT_THROW(horizon_tangents(field, {0.0, 0.0}), ContractViolation);
  EXPECT_THROW(horizon_tangents(field, {1.0, 0.0}, {.earth_radius = 0.0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
